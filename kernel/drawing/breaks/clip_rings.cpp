#include "strip_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace burin {
namespace {

using Ring = std::vector<Vec2>;

/// Cuts the rings of an area at one side of a strip.
class RingCutter {
 public:
  /// `way`: 1 keeps what lies above the side, -1 below.
  RingCutter(const Strip& strip, double side, double way) : strip_(strip), side_(side), way_(way) {}

  std::vector<Ring> run(std::vector<Ring> rings) {
    for (Ring& ring : rings) take(std::move(ring));
    join();
    return std::move(kept_);
  }

 private:
  /// A stretch of a ring from the side to the side.
  struct Chain {
    Ring points;
    bool used = false;
  };

  double inside(Vec2 p) const { return way_ * (strip_.at(p) - side_); }
  double across(Vec2 p) const { return glm::dot(strip_.across(), p); }

  void take(Ring ring) {
    const std::size_t n = ring.size();
    std::vector<double> in(n);
    for (std::size_t i = 0; i < n; ++i) in[i] = inside(ring[i]);
    const auto is_in = [&](std::size_t i) { return in[i % n] >= 0; };
    std::size_t first = 0;
    while (first < n && is_in(first)) ++first;
    if (first == n) {
      if (n > 0) kept_.push_back(std::move(ring));
      return;
    }
    // From a point outside on, so that no stretch is parted.
    for (std::size_t k = first; k < first + n; ++k) {
      const std::size_t i = k % n, j = (k + 1) % n;
      if (is_in(i)) chains_.back().points.push_back(ring[i]);
      if (is_in(i) == is_in(j)) continue;
      if (is_in(j)) chains_.emplace_back();
      chains_.back().points.push_back(glm::mix(ring[i], ring[j], in[i] / (in[i] - in[j])));
    }
  }

  /// What is between the first and the second place at which rings meet the side is inside of the
  /// area, and so on: the even-odd rule.
  void join() {
    std::vector<std::size_t> ends(2 * chains_.size());
    for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = i;
    std::ranges::stable_sort(ends, {}, [&](std::size_t end) { return across(place_of(end)); });
    std::vector<std::size_t> other(ends.size());
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
      other[ends[k]] = ends[k + 1];
      other[ends[k + 1]] = ends[k];
    }
    for (std::size_t start = 0; start < chains_.size(); ++start) {
      if (chains_[start].used) continue;
      Ring ring;
      for (std::size_t end = 2 * start; !chains_[end / 2].used; end = other[end ^ 1U]) {
        chains_[end / 2].used = true;
        Ring points = chains_[end / 2].points;
        if (end % 2 == 1) std::ranges::reverse(points);
        ring.insert(ring.end(), points.begin(), points.end());
        add_edge(points.back(), place_of(other[end ^ 1U]), ring);
      }
      if (ring.size() >= 3) kept_.push_back(std::move(ring));
    }
  }

  /// Ends of chains are numbered by twos.
  Vec2 place_of(std::size_t end) const {
    const Ring& points = chains_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }

  /// The points of the edge between two places on it.
  void add_edge(Vec2 from, Vec2 to, Ring& ring) const {
    const double a = across(from), b = across(to);
    Ring between;
    for (const Vec2& point : strip_.edge) {
      if (point.x <= std::min(a, b) || point.x >= std::max(a, b)) continue;
      between.push_back(point.x * strip_.across() + (side_ + point.y) * strip_.along);
    }
    if (b < a) std::ranges::reverse(between);
    ring.insert(ring.end(), between.begin(), between.end());
  }

  const Strip& strip_;
  double side_, way_;
  std::vector<Chain> chains_;
  std::vector<Ring> kept_;
};

}  // namespace

std::vector<std::vector<Vec2>> clipped_rings(std::vector<std::vector<Vec2>> rings,
                                             const Strip& strip) {
  for (Ring& ring : rings) ring = detail::refined_ring(std::move(ring), strip);
  if (std::isfinite(strip.low)) rings = RingCutter(strip, strip.low, 1).run(std::move(rings));
  if (std::isfinite(strip.high)) rings = RingCutter(strip, strip.high, -1).run(std::move(rings));
  return rings;
}

}  // namespace burin
