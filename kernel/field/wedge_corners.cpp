#include "wedge_corners.h"

#include <array>

namespace burin::field {

Groups<HalfEdge> wedge_corners(const ProxyMesh& proxy) {
  return grouped(
      proxy.wedge_vertex.size(), proxy.wedges.size(),
      [&](std::size_t f) { return proxy.wedges[f]; },
      [](std::size_t f) {
        const auto h = static_cast<HalfEdge>(3 * f);
        return std::array{h, h + 1, h + 2};
      });
}

}  // namespace burin::field
