#include "travel.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace burin::detail {
namespace {

constexpr int kMostTries = 1000;

Box3 moved(Box3 box, Vec3 by) {
  box.min += by, box.max += by;
  return box;
}

/// One part among those that leave, or that are still there, seen along a direction.
struct PlacedPart {
  std::size_t part = 0;
  /// Where it is while others leave, and over all places that it takes once the level has come
  /// apart; of what leaves both without its way along the direction.
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
    is_inner_.resize(s.shapes.boxes.size());
    for (const std::size_t part : inner_) is_inner_[part] = true;
    for (const std::size_t part : level.base.parts) box.add(s.shapes.boxes[part]);
    for (const Removal& removal : level.removals) {
      for (const Node& node : removal.nodes) {
        for (const std::size_t part : node.parts) box.add(s.shapes.boxes[part]);
      }
    }
    gap_ = 0.5 * s.options.gap * (box.diagonal() + s.shapes.diagonal);
  }

  Travel travel(const Removal& removal, std::int64_t& crowded) {
    std::vector<std::size_t> parts;
    for (const Node& node : removal.nodes) {
      parts.insert(parts.end(), node.parts.begin(), node.parts.end());
    }
    const std::size_t d = removal.direction;
    Travel travel;
    for (const Node& node : removal.nodes) {
      travel.follow.push_back(follow(node, s_.along(d)));
      for (const std::size_t part : node.parts) moves_[part] = travel.follow.back();
    }
    const std::vector<PlacedPart> leaving = placed(parts, d, true),
                                  there = placed(inner_, d, false);
    double by = gap_;
    for (const PlacedPart& a : leaving) {
      for (const PlacedPart& b : there) by = std::max(by, past(a, b, d));
    }
    int tries = 0;
    while (raise(leaving, there, d, by)) {
      s_.context.check();
      if (++tries >= kMostTries) {
        ++crowded;
        break;
      }
    }
    for (const std::size_t part : parts) {
      moves_[part] += by * s_.along(d);
      directions_[part] = d;
      is_inner_[part] = true;
      inner_.push_back(part);
    }
    travel.by = by;
    return travel;
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
  /// The way of what a node comes off, the one of the parts there that it touches most, as far as
  /// it is not the node's own.
  Vec3 follow(const Node& node, Vec3 along) const {
    std::map<std::size_t, double> areas;
    for (const std::size_t part : node.parts) {
      for (const Neighbour& other : s_.neighbours[part]) {
        if (is_inner_[other.part]) areas[other.part] += other.area;
      }
    }
    double most = 0;
    Vec3 across(0);
    constexpr double kMore = 1 + 1e-3;  // of two alike the first
    for (const auto& [part, area] : areas) {
      if (area <= kMore * most) continue;
      most = area;
      across = reject(moves_[part], along);
    }
    constexpr double kSame = 1e-6;
    return glm::length(across) > kSame * s_.shapes.diagonal ? across : Vec3(0);
  }

  std::vector<PlacedPart> placed(const std::vector<std::size_t>& parts, std::size_t d,
                                 bool leaving) const {
    const AxisView& view = s_.view(d);
    std::vector<PlacedPart> all;
    for (const std::size_t part : parts) {
      PlacedPart one{part, {}, {}, directions_[part]};
      const Box3& box = view.boxes[part];
      for (const Vec3& place : ways_[part]) {
        one.rest.add(moved(box, in_rows(view.rows, place)));
        one.later.add(moved(box, in_rows(view.rows, place + moves_[part])));
      }
      // What is still there has not come apart yet where others pass it.
      if (!leaving) one.rest = box;
      all.push_back(one);
    }
    return all;
  }

  double fit(const PlacedPart& a, const PlacedPart& b) const {
    return fit_of(s_.shapes, a.part, b.part, s_.options.fit);
  }

  /// Whether both stand before each other as they did together, but for ways along a direction, and
  /// neither comes apart itself: then what rays saw of the one in the other's column holds.
  bool as_seen(const PlacedPart& a, const PlacedPart& b, std::size_t d) const {
    if (ways_[a.part].size() > 1 || ways_[b.part].size() > 1) return false;
    constexpr double kSame = 1e-9;
    return glm::length(reject(moves_[a.part] - moves_[b.part], s_.along(d))) <=
           kSame * s_.shapes.diagonal;
  }

  /// The way past a part in whose column another stands.
  double past(const PlacedPart& a, const PlacedPart& b, std::size_t d) const {
    const double from = s_.reach(d, a.later).x;
    const Column* column = s_.view(d).column(a.part, b.part);
    double by = 0;
    if (ways_[a.part].size() > 1) {
      if (overlap_across(a.rest, b.rest, fit(a, b))) by = s_.reach(d, b.rest).y - from + gap_;
    } else if (column) {
      by = s_.reach(d, *column).y - from + gap_;
    }
    if (as_seen(a, b, d)) {
      const double on = glm::dot(moves_[b.part], s_.along(d));
      if (column && on > 0) by = std::max(by, s_.reach(d, *column).y + on - from + gap_);
    } else if (b.direction == d && overlap_across(a.later, b.later, fit(a, b))) {
      by = std::max(by, s_.reach(d, b.later).y - from + gap_);
    }
    return by;
  }

  /// Past what is in the way of a place; whether anything was.
  bool raise(const std::vector<PlacedPart>& leaving, const std::vector<PlacedPart>& there,
             std::size_t d, double& by) const {
    const double before = by;
    for (const PlacedPart& a : leaving) {
      for (const PlacedPart& b : there) {
        if (ways_[a.part].size() > 1) clear(a.rest, b.rest, a, b, d, by);
        if (!as_seen(a, b, d)) clear(a.later, b.later, a, b, d, by);
      }
    }
    return by > before;
  }

  void clear(const Box3& one, const Box3& other, const PlacedPart& a, const PlacedPart& b,
             std::size_t d, double& by) const {
    if (!overlap_across(one, other, fit(a, b))) return;
    const Vec2 own = s_.reach(d, one), box = s_.reach(d, other);
    const double rounding = 1e-9 * s_.shapes.diagonal;
    if (own.x + by < box.y + gap_ - rounding && own.y + by > box.x - gap_ + rounding) {
      by = box.y + gap_ - own.x;
    }
  }

  const Situation& s_;
  Ways& ways_;
  std::vector<Vec3> moves_;
  std::vector<std::size_t> directions_;
  std::vector<std::size_t> inner_;
  std::vector<bool> is_inner_;
  double gap_ = 0;
};

}  // namespace

std::vector<Travel> travels(const Level& level, const Situation& situation, Ways& ways,
                            std::int64_t& crowded) {
  OneLevel one(level, situation, ways);
  std::vector<Travel> travels(level.removals.size());
  for (std::size_t i = level.removals.size(); i-- > 0;) {
    situation.context.check();
    travels[i] = one.travel(level.removals[i], crowded);
  }
  one.finish();
  return travels;
}

}  // namespace burin::detail
