#include "exact_places.h"

namespace burin::detail {

ExactAt exact_places(const Surface& surface) {
  if (!surface.exact()) return {};
  return [&surface](std::uint32_t face, Vec3 bary) {
    const SurfacePoint point = surface.lift({face, bary});
    return ExactPlace{point.position, surface.frame(point).normal};
  };
}

}  // namespace burin::detail
