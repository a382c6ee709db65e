#include "ink.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

constexpr double kVisibleWidthChange = 0.01;  // paper mm

}  // namespace

bool is_finite(const Path& path) {
  const auto number = [](double x) { return std::isfinite(x); };
  const auto point = [](Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); };
  const auto point3 = [](Vec3 p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  };
  return std::all_of(path.points.begin(), path.points.end(), point) &&
         std::all_of(path.points3.begin(), path.points3.end(), point3) &&
         std::all_of(path.width.begin(), path.width.end(), number);
}

double mean_width(const Path& path) {
  const std::size_t n = path.points.size();
  if (path.width.empty()) return 0;
  if (path.width.size() != n || n < 2) return path.width.front();
  double ink = 0, length = 0;
  for (std::size_t i = 0; i + (path.closed ? 0 : 1) < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const double l = glm::distance(path.points[i], path.points[j]);
    ink += l * 0.5 * (path.width[i] + path.width[j]);
    length += l;
  }
  return length > 0 ? ink / length : path.width.front();
}

bool has_varying_width(const Path& path) {
  if (path.width.size() != path.points.size() || path.width.size() < 2) return false;
  const auto [low, high] = std::minmax_element(path.width.begin(), path.width.end());
  return *high - *low > kVisibleWidthChange;
}

}  // namespace burin
