#pragma once
/// Axis-aligned boxes of points in space and on paper.

#include <burin/base/vec.h>

#include <limits>

namespace burin {

/// An axis-aligned box; empty (min > max) until something is added to it.
template <class Vec>
struct Box {
  Vec min = Vec(std::numeric_limits<double>::infinity());
  Vec max = Vec(-std::numeric_limits<double>::infinity());

  void add(const Vec& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void add(const Box& b) {
    min = glm::min(min, b.min);
    max = glm::max(max, b.max);
  }
  bool empty() const { return min.x > max.x; }
  Vec center() const { return 0.5 * (min + max); }
  Vec size() const { return empty() ? Vec(0) : max - min; }
  double diagonal() const { return glm::length(size()); }
  bool contains(const Vec& p) const { return overlaps({p, p}); }
  bool overlaps(const Box& b) const {
    for (glm::length_t i = 0; i < Vec::length(); ++i) {
      if (min[i] > b.max[i] || b.min[i] > max[i]) return false;
    }
    return true;
  }
  bool operator==(const Box&) const = default;
};

using Box2 = Box<Vec2>;
using Box3 = Box<Vec3>;

}  // namespace burin
