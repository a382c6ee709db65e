#pragma once
// The finished triangles as a proxy.

#include <burin/mesh/proxy_mesh.h>

#include "exact_mesh.h"

namespace burin {

/// Drops unused vertices, tells sharp edges and measures how far the triangles are from f = 0.
ProxyDraft make_draft(const ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context);

}  // namespace burin
