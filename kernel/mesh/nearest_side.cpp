#include <burin/base/nearest_along.h>
#include <burin/mesh/nearest_side.h>

#include <limits>

namespace burin {

Vec3 nearest_side(const TriMesh& mesh, std::uint32_t triangle, Vec3 p) {
  const Triangle& t = mesh.triangles[triangle];
  Vec3 best(1, 0, 0);
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int n = (k + 1) % 3;
    const Vec3 a = mesh.positions[t[static_cast<std::size_t>(k)]];
    const Vec3 d = mesh.positions[t[static_cast<std::size_t>(n)]] - a;
    const double s = nearest_along(a, d, p), gap = glm::distance(p, a + s * d);
    if (gap >= least) continue;
    least = gap;
    best = Vec3(0);
    best[k] = 1 - s;
    best[n] = s;
  }
  return best;
}

}  // namespace burin
