#include <burin/mesh/chord_error.h>

#include <algorithm>
#include <cmath>

namespace burin {

double chord_error(const ProxyMesh& proxy, std::uint32_t face) {
  if (proxy.wedges.empty()) return 0;
  // k h^2 / 8 of each edge h, where k h^2 / 2 is how far the edge leaves the tangent plane at
  // either end. The smaller of both: what bends at one end only is not bent along the edge. A
  // diagonal of a cylinder's long facet has the sagitta of the facet.
  double largest = 0;
  const Triangle& w = proxy.wedges[face];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = w[i], b = w[(i + 1) % 3];
    const Vec3 edge = proxy.wedge_position(b) - proxy.wedge_position(a);
    const double at_a = glm::dot(proxy.wedge_normal[a], edge),
                 at_b = glm::dot(proxy.wedge_normal[b], edge);
    if ((at_a < 0) == (at_b > 0))
      largest = std::max(largest, std::min(std::abs(at_a), std::abs(at_b)));
  }
  return largest / 4;
}

}  // namespace burin
