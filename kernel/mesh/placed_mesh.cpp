#include <burin/mesh/placed_mesh.h>

#include <algorithm>
#include <utility>

namespace burin {

TriMesh placed(TriMesh mesh, const Placement& by) {
  for (Vec3& p : mesh.positions) p = by.point(p);
  if (by.mirrors()) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return mesh;
}

PolygonSoup placed(PolygonSoup soup, const Placement& by) {
  for (Vec3& p : soup.positions) p = by.point(p);
  if (!by.mirrors()) return soup;
  const auto turn = [](auto& corners, std::size_t begin, std::size_t end) {
    const auto first = corners.begin() + static_cast<std::ptrdiff_t>(begin) + 1;
    std::reverse(first, corners.begin() + static_cast<std::ptrdiff_t>(end));
  };
  for (std::size_t i = 0; i < soup.polygon_count(); ++i) {
    const std::size_t begin = soup.offsets[i], end = soup.offsets[i + 1];
    if (begin == end) continue;
    turn(soup.indices, begin, end);
    if (!soup.texture.empty()) turn(soup.texture, begin, end);
  }
  return soup;
}

}  // namespace burin
