#include <burin/work_mesh/proxy_draft.h>

namespace burin {

ProxyDraft proxy_draft(const ChartMesh& mesh) {
  ProxyDraft draft;
  draft.mesh.positions = mesh.positions;
  draft.mesh.triangles = mesh.triangles;
  draft.corner_normal = mesh.normal;
  draft.corner_on_contour = mesh.on_contour;
  draft.source_face = mesh.face;
  draft.tolerance = mesh.tolerance;
  const std::size_t count = mesh.border.size();
  draft.sharp.assign(count, 0);
  draft.seam.assign(count, 0);
  draft.source_edge.assign(count, -1);
  for (std::size_t h = 0; h < count; ++h) {
    if (mesh.border[h] < 0) continue;
    draft.sharp[h] = mesh.border_class(h) == ModelEdgeClass::Sharp;
    draft.seam[h] = mesh.border_class(h) == ModelEdgeClass::Seam;
    draft.source_edge[h] = mesh.borders[static_cast<std::size_t>(mesh.border[h])].edge;
  }
  return draft;
}

}  // namespace burin
