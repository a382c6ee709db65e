#include "sample_grid.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Cosine: where families meet, lines run up to those of the other one.
constexpr double kSameWay = 0.7;

}  // namespace

bool same_sheet(const GridSample& a, const GridSample& b) {
  // The sheet bends between the two: twice the larger slope leaves room for that. And two samples
  // closer than a thin line (paper mm) are one place however steep the sheet is: else neighbours
  // could be set on each other without end.
  constexpr double kOnePlace = 0.1;
  if (a.part != b.part || a.region != b.region) return false;
  const double reach =
      2 * std::max(a.slope, b.slope) * (glm::length(a.paper - b.paper) + kOnePlace);
  return std::abs(a.depth - b.depth) <= reach;
}

SampleGrid::SampleGrid(Vec2 origin, Vec2 size, double cell)
    : origin_(origin),
      cell_(cell),
      nx_(static_cast<std::int32_t>(size.x / cell) + 1),
      ny_(static_cast<std::int32_t>(size.y / cell) + 1),
      cells_(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_)) {}

void SampleGrid::insert(const GridSample& sample) {
  const Vec2 q = (sample.paper - origin_) / cell_;
  const auto x = std::clamp(static_cast<std::int32_t>(std::floor(q.x)), 0, nx_ - 1);
  const auto y = std::clamp(static_cast<std::int32_t>(std::floor(q.y)), 0, ny_ - 1);
  cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x)]
      .push_back(sample);
}

template <class Visit>
void SampleGrid::visit(const GridSample& at, double radius, const Visit& f) const {
  const auto index = [&](double v, std::int32_t n) {
    return std::clamp(static_cast<std::int32_t>(std::floor(v / cell_)), 0, n - 1);
  };
  const Vec2 p = at.paper - origin_;
  const std::int32_t x0 = index(p.x - radius, nx_), x1 = index(p.x + radius, nx_);
  const std::int32_t y0 = index(p.y - radius, ny_), y1 = index(p.y + radius, ny_);
  for (std::int32_t y = y0; y <= y1; ++y) {
    for (std::int32_t x = x0; x <= x1; ++x) {
      for (const GridSample& s :
           cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) +
                  static_cast<std::size_t>(x)]) {
        f(s);
      }
    }
  }
}

double SampleGrid::nearest(const GridSample& at, double radius) const {
  const bool line = at.direction != Vec2(0);
  double best = radius;
  visit(at, radius, [&](const GridSample& s) {
    if (line && s.pace > 0 && std::abs(glm::dot(at.direction, s.direction)) < kSameWay) return;
    const Vec2 d = at.paper - s.paper;
    const double d2 = glm::dot(d, d);
    if (d2 >= best * best + s.pace * s.pace) return;
    const double along = std::abs(glm::dot(d, s.direction));
    const double across = std::abs(cross2(s.direction, d));
    const double distance = along < s.pace ? across : std::sqrt(d2);
    if (distance < best && same_sheet(at, s)) best = distance;
  });
  return best;
}

SampleGrid::Sides SampleGrid::sides(const GridSample& at, double radius) const {
  Sides out{radius, radius};
  visit(at, radius, [&](const GridSample& s) {
    if (s.stroke == at.stroke) return;
    const Vec2 d = s.paper - at.paper;
    const double across = cross2(at.direction, d), along = glm::dot(at.direction, d);
    // Neighbours beside the place, not before or behind it. A sample of a line that runs the same
    // way stands for its piece of it: else, of near lines out of step, the next but one is found.
    const bool same_way = std::abs(glm::dot(at.direction, s.direction)) > kSameWay;
    if (std::abs(along) > std::max(0.7 * std::abs(across), same_way ? s.pace : 0)) return;
    double& side = across > 0 ? out.left : out.right;
    if (!(std::abs(across) < side && same_sheet(at, s))) return;
    side = std::abs(across);
    (across > 0 ? out.left_weight : out.right_weight) = s.weight;
  });
  return out;
}

}  // namespace burin::detail
