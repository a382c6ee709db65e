#include <burin/drawing/bezier.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace burin {
namespace {

/// Squared distance of p from the segment that starts at a and has the vector d of squared length
/// dd.
template <class Vec>
double distance2(Vec p, Vec a, Vec d, double dd) {
  const Vec v = p - a;
  const double along = glm::dot(v, d);
  if (along <= 0 || dd == 0) return glm::dot(v, v);
  const Vec w = v - d * std::min(along / dd, 1.0);
  return glm::dot(w, w);
}

template <class Vec>
std::vector<std::size_t> douglas_peucker(std::span<const Vec> points, double tolerance) {
  const std::size_t n = points.size();
  std::vector<std::size_t> kept;
  if (n == 0) return kept;
  std::vector<std::uint8_t> keep(n, 0);
  keep[0] = keep[n - 1] = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, n - 1}};
  const double limit = tolerance * tolerance;
  // Of points that are equally far the first: along a stroke of one width all are, but for noise.
  constexpr double kFarther = 1 + 1e-9;
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const Vec a = points[first], d = points[last] - a;
    const double dd = glm::dot(d, d);
    double worst = limit;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double e = distance2(points[i], a, d, dd);
      if (e > kFarther * worst) {
        worst = e;
        at = i;
      }
    }
    if (at == first) continue;
    keep[at] = 1;
    open.push_back({first, at});
    open.push_back({at, last});
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (keep[i]) kept.push_back(i);
  }
  return kept;
}

}  // namespace

std::vector<std::size_t> simplify(std::span<const Vec2> points, double tolerance) {
  return douglas_peucker(points, tolerance);
}

std::vector<std::size_t> simplify(std::span<const Vec3> points, double tolerance) {
  return douglas_peucker(points, tolerance);
}

}  // namespace burin
