#include <burin/surface/face_samples.h>

#include <algorithm>

namespace burin {

std::vector<SampledPoint> face_samples(const Surface& surface,
                                       std::span<const std::uint32_t> triangles,
                                       std::size_t about) {
  std::vector<SampledPoint> out;
  const std::size_t step = std::max<std::size_t>(1, 3 * triangles.size() / about);
  for (std::size_t i = 0; i < triangles.size(); i += step) {
    for (int corner = 0; corner < 3; ++corner) {
      Vec3 bary(0.1);
      bary[corner] = 0.8;
      const Frame frame = surface.frame(surface.lift({triangles[i], bary}));
      out.push_back({frame.position, frame.normal});
    }
  }
  return out;
}

std::map<std::int32_t, std::vector<std::uint32_t>> triangles_of_faces(const ProxyMesh& proxy) {
  std::map<std::int32_t, std::vector<std::uint32_t>> faces;
  for (std::uint32_t i = 0; i < proxy.mesh.triangles.size(); ++i) {
    if (!proxy.is_cut(i)) faces[proxy.face_source(i)].push_back(i);
  }
  return faces;
}

}  // namespace burin
