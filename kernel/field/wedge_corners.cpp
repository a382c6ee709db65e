#include "wedge_corners.h"

namespace burin::field {

WedgeCorners::WedgeCorners(const ProxyMesh& proxy) {
  first.assign(proxy.wedge_vertex.size() + 1, 0);
  for (const Triangle& t : proxy.wedges) {
    for (const std::uint32_t w : t) ++first[w + 1];
  }
  for (std::size_t w = 1; w < first.size(); ++w) first[w] += first[w - 1];
  corner.resize(3 * proxy.wedges.size());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t f = 0; f < proxy.wedges.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      corner[next[proxy.wedges[f][k]]++] = static_cast<HalfEdge>(3 * f + k);
    }
  }
}

}  // namespace burin::field
