#include <burin/base/disjoint_sets.h>
#include <burin/mesh/whole_faces.h>

#include <algorithm>

namespace burin {

std::vector<std::int32_t> whole_faces(const ProxyMesh& proxy) {
  if (proxy.seam.empty() || proxy.source_face.empty()) return {};
  const auto face_at = [&](HalfEdge h) {
    return static_cast<std::uint32_t>(proxy.source_face[face_of(h)]);
  };
  const std::int32_t count = *std::ranges::max_element(proxy.source_face) + 1;
  DisjointSets sets(static_cast<std::size_t>(count));
  bool any = false;
  for (HalfEdge h = 0; static_cast<std::size_t>(h) < proxy.seam.size(); ++h) {
    const HalfEdge other = proxy.topology.opposite[static_cast<std::size_t>(h)];
    if (proxy.seam[static_cast<std::size_t>(h)] == 0 || other == kNoHalfEdge) continue;
    if (face_at(h) == face_at(other)) continue;
    sets.join(face_at(h), face_at(other));
    any = true;
  }
  if (!any) return {};
  std::vector<std::int32_t> out;
  for (std::int32_t f = 0; f < count; ++f) {
    out.push_back(static_cast<std::int32_t>(sets.find(static_cast<std::uint32_t>(f))));
  }
  return out;
}

}  // namespace burin
