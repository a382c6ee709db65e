#include "trails.h"

#include <burin/base/disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace burin::detail {
namespace {

// Shares of the assembly's diagonal.
constexpr double kSamePlace = 1e-6;
constexpr double kSameLine = 2e-3;

/// A way from `from` straight to `bend` and on to `to`, where both differ.
struct Trail {
  Vec3 from{0}, bend{0}, to{0};
  std::size_t part = 0;
  /// Which step it is of, what moved, and whether it lies on an axis of round faces.
  std::size_t step = 0;
  std::vector<std::size_t> group = {};
  bool on_axis = false;

  bool straight() const { return bend == to; }
};

class Maker {
 public:
  Maker(const std::vector<ExplodeStep>& steps, double factor, const Shapes& shapes,
        const std::vector<Contact>& contacts)
      : steps_(steps), factor_(factor), shapes_(shapes), contacts_(contacts) {
    at_end_ = moves_of(steps, shapes.boxes.size(), factor);
    before_.resize(shapes.boxes.size());
  }

  std::vector<Trail> all() {
    std::vector<Trail> trails;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const ExplodeStep& step = steps_[i];
      if (step.trail) {
        for (auto& group : groups(step)) {
          auto trail = best(step, group);
          if (!trail) continue;
          trail->step = i;
          trail->group = std::move(group);
          trails.push_back(std::move(*trail));
        }
      }
      for (const std::size_t part : step.parts) before_[part] += factor_ * step.by * step.along;
    }
    std::vector<Trail> shown;
    for (const Trail& trail : trails) {
      if (!is_shown_by_others(trail, trails)) shown.push_back(trail);
    }
    return shown;
  }

 private:
  /// A lid needs no line through its middle where those of its screws run through its holes.
  bool is_shown_by_others(const Trail& trail, const std::vector<Trail>& all) const {
    if (trail.on_axis) return false;
    const Vec3 along = steps_[trail.step].along;
    return std::ranges::any_of(contacts_, [&](const Contact& c) {
      if (!c.round || !same_axis(c.axis, along)) return false;
      const bool own = std::ranges::binary_search(trail.group, c.part),
                 other = std::ranges::binary_search(trail.group, c.other);
      if (own == other) return false;
      const std::size_t partner = own ? c.other : c.part;
      return std::ranges::any_of(all, [&](const Trail& one) {
        return one.on_axis && same_axis(steps_[one.step].along, along) &&
               std::ranges::binary_search(one.group, partner);
      });
    });
  }

  bool together(std::size_t a, std::size_t b) const {
    return glm::distance(before_[a], before_[b]) <= kSamePlace * shapes_.diagonal;
  }

  /// The parts of a step that hang together.
  std::vector<std::vector<std::size_t>> groups(const ExplodeStep& step) const {
    DisjointSets sets(shapes_.boxes.size());
    for (const Contact& c : contacts_) {
      if (moves(step, c.part) && moves(step, c.other) && together(c.part, c.other)) {
        sets.join(static_cast<std::uint32_t>(c.part), static_cast<std::uint32_t>(c.other));
      }
    }
    std::map<std::uint32_t, std::vector<std::size_t>> by_name;
    for (const std::size_t part : step.parts) {
      by_name[sets.find(static_cast<std::uint32_t>(part))].push_back(part);
    }
    std::vector<std::vector<std::size_t>> groups;
    for (auto& [name, parts] : by_name) groups.push_back(std::move(parts));
    return groups;
  }

  static bool moves(const ExplodeStep& step, std::size_t part) {
    return std::ranges::binary_search(step.parts, part);
  }

  /// Where the line runs: on the axis of round faces that touch, else of a round face of either
  /// part that stands on the contact, else through the middle of it.
  Vec3 middle(const Contact& contact, Vec3 along) const {
    if (contact.round && same_axis(contact.axis, along)) return contact.middle;
    const Contact* round = nullptr;
    for (const Contact& c : contacts_) {
      const bool of_pair = c.part == contact.part || c.other == contact.part;
      if (!of_pair || !c.round || !same_axis(c.axis, along)) continue;
      const double off = glm::length(reject(c.middle - contact.middle, along));
      const double reach = 0.25 * std::min(shapes_.boxes[contact.part].diagonal(),
                                           shapes_.boxes[contact.other].diagonal());
      if (off <= reach && (!round || c.area > round->area)) round = &c;
    }
    if (!round) return contact.middle;
    return round->middle + glm::dot(contact.middle - round->middle, along) * along;
  }

  /// Of all contacts between what moves and what stays, the trail that is straight, then of the
  /// part that is farthest, then on an axis, then of the smaller part's face, then of most area.
  std::optional<Trail> best(const ExplodeStep& step, const std::vector<std::size_t>& group) const {
    std::optional<Trail> best;
    std::tuple<double, double, bool, double, double> least;
    for (const Contact& c : contacts_) {
      const bool own = std::ranges::binary_search(group, c.part),
                 other = std::ranges::binary_search(group, c.other);
      if (own == other || !together(c.part, c.other)) continue;
      const std::size_t a = own ? c.part : c.other, b = own ? c.other : c.part;
      if (moves(step, b)) continue;
      Trail trail = way(step, middle(c, step.along), a, b);
      trail.on_axis = c.round && same_axis(c.axis, step.along);
      const double unit = kSamePlace * shapes_.diagonal;
      const auto rounded = [&](double mm) { return std::round(mm / unit); };
      const double length = glm::dot(trail.to - trail.from, trail.to - trail.from) > 0
                                ? std::abs(glm::dot(trail.bend - trail.from, step.along))
                                : 0;
      if (length <= unit) continue;
      const std::tuple rank(rounded(glm::distance(trail.bend, trail.to)), -rounded(length),
                            !trail.on_axis, rounded(shapes_.boxes[c.part].diagonal()), -c.area);
      if (!best || rank < least) best = trail, least = rank;
    }
    return best;
  }

  /// From the moved part back along the step, then to where the other part is.
  Trail way(const ExplodeStep& step, Vec3 middle, std::size_t a, std::size_t b) const {
    Trail trail;
    trail.part = a;
    trail.from = middle + at_end_[a];
    trail.to = middle + at_end_[b];
    const double back = glm::dot(trail.to - trail.from, step.along);
    trail.bend = trail.from + back * step.along;
    if (glm::distance(trail.bend, trail.to) <= kSameLine * shapes_.diagonal) trail.bend = trail.to;
    return trail;
  }

  const std::vector<ExplodeStep>& steps_;
  double factor_;
  const Shapes& shapes_;
  const std::vector<Contact>& contacts_;
  std::vector<Vec3> before_, at_end_;
};

/// Joins straight trails that lie on one line and meet.
class Stacks {
 public:
  explicit Stacks(double diagonal) : near_(kSameLine * diagonal) {}

  void add(const Trail& trail) {
    Trail one = trail;
    for (bool again = true; again;) {
      again = false;
      for (auto other = trails_.begin(); other != trails_.end(); ++other) {
        if (!joins(one, *other)) continue;
        one = joined(*other, one);
        trails_.erase(other);
        again = true;
        break;
      }
    }
    trails_.push_back(one);
  }

  const std::vector<Trail>& trails() const { return trails_; }

 private:
  bool joins(const Trail& a, const Trail& b) const {
    if (!a.straight() || !b.straight()) return false;
    const Vec3 along = glm::normalize(b.to - b.from);
    for (const Vec3& p : {a.from, a.to}) {
      if (glm::length(reject(p - b.from, along)) > near_) return false;
    }
    const double end = glm::dot(b.to - b.from, along);
    const auto [low, high] =
        std::minmax({glm::dot(a.from - b.from, along), glm::dot(a.to - b.from, along)});
    // Neighbours in a stack meet inside the part between them, not in one place.
    const double slack = std::max(high - low, end);
    return low <= end + slack && high >= -slack;
  }

  static Trail joined(const Trail& first, const Trail& second) {
    const Vec3 along = glm::normalize(first.to - first.from);
    double low = 0, high = glm::dot(first.to - first.from, along);
    for (const Vec3& p : {second.from, second.to}) {
      const double t = glm::dot(p - first.from, along);
      low = std::min(low, t);
      high = std::max(high, t);
    }
    Trail all = first;
    all.from = first.from + low * along;
    all.to = all.bend = first.from + high * along;
    return all;
  }

  double near_;
  std::vector<Trail> trails_;
};

}  // namespace

std::vector<Curve3> make_trails(const std::vector<ExplodeStep>& steps, double factor,
                                const Shapes& shapes, const std::vector<Contact>& contacts) {
  Stacks stacks(shapes.diagonal);
  for (const Trail& trail : Maker(steps, factor, shapes, contacts).all()) stacks.add(trail);
  std::vector<Curve3> curves;
  for (const Trail& trail : stacks.trails()) {
    Curve3 curve;
    curve.kind = LineClass::Trail;
    curve.source.part = static_cast<std::int32_t>(trail.part);
    curve.points = {trail.from, trail.bend};
    if (!trail.straight()) curve.points.push_back(trail.to);
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace burin::detail
