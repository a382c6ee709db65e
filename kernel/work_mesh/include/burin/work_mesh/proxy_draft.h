#pragma once
/// From triangles over faces to a proxy.

#include <burin/mesh/proxy_mesh.h>
#include <burin/work_mesh/chart_mesh.h>

namespace burin {

/// What `assemble_proxy` wants to know of a chart mesh; faces and model edges keep their numbers.
ProxyDraft proxy_draft(const ChartMesh& mesh);

}  // namespace burin
