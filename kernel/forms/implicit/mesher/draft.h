#pragma once
// The finished triangles as a proxy.

#include <burin/mesh/proxy_mesh.h>

#include "exact_mesh.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Half-edges (3t + k) along creases, by the normals of all corners: nonzero where those of the two
/// triangles differ.
std::vector<std::uint8_t> sharp_halves(const ExactMesh& mesh, std::span<const Vec3> corner_normal);

/// How far each triangle is from f = 0, in model mm, to the first order; 0 where the function does
/// not tell.
std::vector<double> deviations(const ExactMesh& mesh, const ImplicitFunction& f,
                               const RunContext& context);

/// Drops unused vertices, tells sharp edges and measures how far the triangles are from f = 0.
ProxyDraft make_draft(const ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context);

}  // namespace burin
