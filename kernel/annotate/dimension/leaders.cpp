#include "frame_path.h"
#include "leader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burin::detail {
namespace {

/// Steps outwards that are tried.
constexpr int kMostLeaderSteps = 40;
/// And where there are many of them.
constexpr int kFewLeaderSteps = 12;
/// Paper mm from the outline to the elbow of a leader.
constexpr double kElbow = 5;

/// Whether a circle is whole: but for what a slot or a seam may take of it.
bool is_whole(const Dimension& dimension) { return dimension.sweep > 350; }

/// The number of a circle over the shelf of its leader.
LeaderEnd number_on_shelf(const DimensionLetters& letters, const DimensionOptions& style) {
  return {[&](Vec2 elbow, double side, DimensionPlace& out) {
    const double h = style.height;
    const Vec2 end = elbow + Vec2(side * (letters.width() + 0.3 * h), 0);
    add_leader_piece(elbow, end, {}, style.line, out);
    const Vec2 low(std::min(elbow.x, end.x) + 0.15 * h, elbow.y + kBelowText * h);
    letters.lay(low, {1, 0}, out.layer);
    out.print.letters.push_back(letters.quad(low, {1, 0}));
  }};
}

/// Where a leader may end.
std::vector<Vec3> tips_of(const Dimension& dimension) {
  return dimension.from_points.empty() ? points_of_round(dimension) : dimension.from_points;
}

}  // namespace

void add_leader_piece(Vec2 a, Vec2 b, const SourceId& source, double width, DimensionPlace& out) {
  Path path = line(a, b, width);
  path.source = source;
  out.layer.paths.push_back(std::move(path));
  out.print.pieces.push_back({a, b, Stroke::Leader});
}

void add_mark(const Leader& leader, const DimensionOptions& style, DimensionPlace& out) {
  // As wide as those of callouts.
  constexpr double kDot = 1.1, kDotLines = 6;
  using Mark = LeaderTarget::Mark;
  if (leader.mark == Mark::None) return;
  Path mark;
  if (leader.mark == Mark::Dot) {
    mark = line(leader.tip, leader.tip, std::max(kDot, kDotLines * style.line));
  } else {
    // The line ends in its arrow, not beside its tip.
    const double length = kArrow * style.height;
    out.layer.paths.back().points.front() = leader.tip + 0.5 * length * leader.way;
    mark = arrow_head(leader.tip, -leader.way, length);
  }
  mark.source = leader.source;
  out.layer.paths.push_back(std::move(mark));
}

DimensionPlace leader_place(const Leader& leader, const LeaderEnd& end,
                            const DimensionGround& ground, double limit) {
  const Vec2 tip = leader.tip, way = leader.way;
  const double exit = exit_of(tip, tip, way, ground.outline);
  const auto make = [&](int step) {
    DimensionPlace out;
    const double length = exit + ground.taken_in(way) + kElbow + step * ground.step();
    const Vec2 elbow = tip + length * way;
    add_leader_piece(tip, elbow, leader.source, ground.style.line, out);
    add_mark(leader, ground.style, out);
    end.lay(elbow, way.x < 0 ? -1 : 1, out);
    // At 45 degrees rather than steeper or flatter; to the right, above.
    // Over the part it may cross what is drawn there.
    constexpr double kSlope = 4, kSide = 1, kLong = 0.4, kOver = 0.2;
    out.cost += kLong * length + kOver * exit +
                kSlope * std::abs(std::abs(way.x) - std::abs(way.y)) - kSide * (way.x + way.y);
    return out;
  };
  return first_free(make, ground.many ? kFewLeaderSteps : kMostLeaderSteps, ground, limit);
}

DimensionPlace place_round(const Dimension& dimension, const DimensionGround& ground) {
  const PaperView& view = ground.view;
  const DimensionLetters letters(dimension, ground.style.height);
  const LeaderEnd end = number_on_shelf(letters, ground.style);
  const Vec2 center = view.at(dimension.from);
  const bool whole = is_whole(dimension);
  // Sines: a leader along the sheet is taken for an edge.
  constexpr double kUpright = 0.25;
  DimensionPlace best;
  for (const double least : {kUpright, 0.0}) {
    best.cost = std::numeric_limits<double>::infinity();
    for (const Vec3& point : tips_of(dimension)) {
      const Vec2 tip = view.at(point);
      const double radius = glm::distance(tip, center);
      if (!(radius > 1e-9)) continue;
      const Vec2 way = (tip - center) / radius;
      if (std::min(std::abs(way.x), std::abs(way.y)) < least) continue;
      for (const double sense : {1.0, -1.0}) {
        if (whole && sense < 0) continue;
        DimensionPlace place = leader_place({tip, sense * way}, end, ground);
        if (place.cost < best.cost - 1e-9) best = std::move(place);
      }
    }
    if (std::isfinite(best.cost)) break;
  }
  return best;
}

}  // namespace burin::detail

namespace burin {

std::vector<Vec3> points_of_round(const Dimension& dimension) {
  constexpr int kPlaces = 48;
  const Vec3 u = dimension.to - dimension.from, v = glm::cross(dimension.other, u);
  // Not the ends of an arc, where it is hard to tell what is meant.
  const double half = detail::is_whole(dimension) ? 180 : 0.4 * dimension.sweep;
  std::vector<Vec3> out;
  for (int i = 0; i <= kPlaces; ++i) {
    const double angle = glm::radians(half * (2.0 * i / kPlaces - 1));
    out.push_back(dimension.from + std::cos(angle) * u + std::sin(angle) * v);
  }
  return out;
}

}  // namespace burin
