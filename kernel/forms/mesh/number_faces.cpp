#include <burin/base/disjoint_sets.h>
#include <burin/forms/mesh/mesh_form.h>

namespace burin {

std::vector<std::int32_t> number_faces(const TriMesh& mesh, std::span<const std::int32_t> kind,
                                       const RunContext& context) {
  const ProxyMesh proxy = build_proxy(mesh, {}, context);
  DisjointSets sets(mesh.triangles.size());
  for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
    const HalfEdge o = proxy.topology.opposite[h];
    if (o == kNoHalfEdge || proxy.edge_kind[h] != EdgeKind::Smooth) continue;
    const std::uint32_t f = face_of(static_cast<HalfEdge>(h)), g = face_of(o);
    if (kind[f] == kind[g]) sets.join(f, g);
  }
  std::vector<std::int32_t> faces(mesh.triangles.size());
  std::int32_t count = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    // Sets are named by their first triangles.
    const std::uint32_t first = sets.find(f);
    faces[f] = first == f ? count++ : faces[first];
  }
  return faces;
}

}  // namespace burin
