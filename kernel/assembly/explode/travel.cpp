#include "travel.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

constexpr int kMostTries = 1000;

Box3 moved(Box3 box, Vec3 by) {
  box.min += by, box.max += by;
  return box;
}

/// One part among those that leave, or that are still there, seen along a direction.
struct Standing {
  std::size_t part = 0;
  /// As it stands, and over all places that it takes on its own after the level has come apart.
  Box3 rest, later;
  std::size_t direction = static_cast<std::size_t>(-1);
};

class OneLevel {
 public:
  OneLevel(const Level& level, const Situation& s, Ways& ways) : s_(s), ways_(ways) {
    moves_.resize(s.shapes.boxes.size());
    directions_.resize(s.shapes.boxes.size(), static_cast<std::size_t>(-1));
    Box3 box;
    inner_ = level.base.parts;
    for (const std::size_t part : level.base.parts) box.add(s.shapes.boxes[part]);
    for (const Removal& removal : level.removals) {
      for (const Node& node : removal.nodes) {
        for (const std::size_t part : node.parts) box.add(s.shapes.boxes[part]);
      }
    }
    gap_ = 0.5 * s.options.gap * (box.diagonal() + s.shapes.diagonal);
  }

  double travel(const Removal& removal, std::int64_t& crowded) {
    std::vector<std::size_t> parts;
    for (const Node& node : removal.nodes) {
      parts.insert(parts.end(), node.parts.begin(), node.parts.end());
    }
    const std::size_t d = removal.direction;
    const std::vector<Standing> leaving = standing(parts, d), there = standing(inner_, d);
    double by = gap_;
    for (const Standing& a : leaving) {
      for (const Standing& b : there) by = std::max(by, past(a, b, d));
    }
    int tries = 0;
    while (raise(leaving, there, d, by)) {
      if (++tries >= kMostTries) {
        ++crowded;
        break;
      }
    }
    const Vec3 move = by * s_.along(d);
    for (const std::size_t part : parts) {
      moves_[part] = move;
      directions_[part] = d;
      inner_.push_back(part);
    }
    return by;
  }

  void finish() {
    for (const std::size_t part : inner_) {
      std::vector<Vec3>& way = ways_[part];
      if (moves_[part] == Vec3(0)) continue;
      for (Vec3& place : way) place += moves_[part];
      way.insert(way.begin(), Vec3(0));
    }
  }

 private:
  std::vector<Standing> standing(const std::vector<std::size_t>& parts, std::size_t d) const {
    const AxisView& view = s_.view(d);
    std::vector<Standing> all;
    for (const std::size_t part : parts) {
      Standing one{part, view.boxes[part], {}, directions_[part]};
      for (const Vec3& place : ways_[part]) {
        one.later.add(moved(one.rest, in_rows(view.rows, place + moves_[part])));
      }
      all.push_back(one);
    }
    return all;
  }

  double fit(const Standing& a, const Standing& b) const {
    return fit_of(s_.shapes, a.part, b.part, s_.options.fit);
  }

  /// The way past a part in whose column, or at whose side, another stands.
  double past(const Standing& a, const Standing& b, std::size_t d) const {
    const double eps = fit(a, b), from = s_.reach(d, a.later).x;
    double by = 0;
    if (overlap_across(a.later, b.rest, eps) || s_.touch(a.part, b.part)) {
      by = s_.reach(d, b.rest).y - from + gap_;
    }
    if (b.direction == d && overlap_across(a.later, b.later, eps)) {
      by = std::max(by, s_.reach(d, b.later).y - from + gap_);
    }
    return by;
  }

  /// Past what is in the way of a place; whether anything was.
  bool raise(const std::vector<Standing>& leaving, const std::vector<Standing>& there,
             std::size_t d, double& by) const {
    const double before = by;
    for (const Standing& a : leaving) {
      const Vec2 one = s_.reach(d, a.later);
      for (const Standing& b : there) {
        for (const Box3& box : {b.rest, b.later}) {
          if (!overlap_across(a.later, box, fit(a, b))) continue;
          const Vec2 other = s_.reach(d, box);
          const double rounding = 1e-9 * s_.shapes.diagonal;
          if (one.x + by < other.y + gap_ - rounding && one.y + by > other.x - gap_ + rounding) {
            by = other.y + gap_ - one.x;
          }
        }
      }
    }
    return by > before;
  }

  const Situation& s_;
  Ways& ways_;
  std::vector<Vec3> moves_;
  std::vector<std::size_t> directions_;
  std::vector<std::size_t> inner_;
  double gap_ = 0;
};

}  // namespace

std::vector<double> travels(const Level& level, const Situation& situation, Ways& ways,
                            std::int64_t& crowded) {
  OneLevel one(level, situation, ways);
  std::vector<double> by(level.removals.size());
  for (std::size_t i = level.removals.size(); i-- > 0;) {
    situation.context.check();
    by[i] = one.travel(level.removals[i], crowded);
  }
  one.finish();
  return by;
}

}  // namespace burin::detail
