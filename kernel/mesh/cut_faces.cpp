#include <burin/mesh/cut_faces.h>

#include <cstddef>
#include <cstdint>
#include <map>

namespace burin {

std::vector<CutFace> cut_faces(const ProxyMesh& proxy) {
  std::map<std::int32_t, CutFace> planes;
  for (std::uint32_t i = 0; i < proxy.mesh.triangles.size() && !proxy.cut_plane.empty(); ++i) {
    if (!proxy.is_cut(i)) continue;
    planes.try_emplace(
        proxy.cut_plane[static_cast<std::size_t>(proxy.face_region[i])],
        CutFace{proxy.mesh.positions[proxy.mesh.triangles[i][0]], proxy.mesh.normal(i)});
  }
  std::vector<CutFace> out;
  for (const auto& [number, plane] : planes) out.push_back(plane);
  return out;
}

}  // namespace burin
