#include "shift.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace burin::detail {
namespace {

/// What a shift has to gain.
constexpr double kGain = 0.02;

}  // namespace

Shift best_shift(const Body& before, const Body& after, double place) {
  Shift best{Vec3(0), share_on_each_other(before, after, {}, place)};
  const Box3 &was = before.pose().box, &is = after.pose().box;
  std::vector<Vec3> shifts{after.pose().middle - before.pose().middle};
  // Sides of the boxes, or their middles, laid on each other.
  const std::array<Vec3, 3> sides{is.min - was.min, is.center() - was.center(), is.max - was.max};
  for (std::size_t n = 0; n < 27; ++n) {
    shifts.emplace_back(sides[n % 3].x, sides[n / 3 % 3].y, sides[n / 9].z);
  }
  for (std::size_t i = 0; i < shifts.size(); ++i) {
    const auto near = [&](Vec3 other) { return glm::distance(other, shifts[i]) <= place; };
    if (near(Vec3(0)) || near(best.by)) continue;
    if (std::any_of(shifts.begin(), shifts.begin() + static_cast<std::ptrdiff_t>(i), near))
      continue;
    const double share = share_on_each_other(before, after, {Mat3(1), shifts[i]}, place);
    // A shift has to be worth it; among shifts the better one.
    const double least = best.by == Vec3(0) ? best.share + kGain : best.share;
    if (share > least) best = {shifts[i], share};
  }
  return best;
}

}  // namespace burin::detail
