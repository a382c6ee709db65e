#include <burin/area/largest_disc.h>
#include <burin/base/box.h>
#include <burin/base/nearest_along.h>
#include <burin/planar/even_odd.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr std::size_t kMostSquares = 20'000;

class Search {
 public:
  Search(std::span<const BorderSide> border, std::span<const BorderSide> across,
         const DiscOptions& options)
      : border_(border), across_(across), options_(options) {}

  InnerDisc run() {
    Box2 box;
    for (const auto& [a, b] : border_) {
      box.add(a);
      box.add(b);
    }
    if (box.empty()) return {};
    Square root{box.center(), 0.5 * std::max(box.size().x, box.size().y)};
    for (std::uint32_t i = 0; i < border_.size() + across_.size(); ++i) root.near.push_back(i);
    look(std::move(root));
    for (std::size_t n = 0; n < kMostSquares && !queue_.empty(); n += 4) {
      if (best_.radius >= options_.enough || queue_.top().most < least_wanted()) break;
      const Square square = queue_.top();
      queue_.pop();
      divide(square);
    }
    return best_;
  }

 private:
  struct Square {
    Vec2 middle{0};
    double half = 0;
    /// No disc with its middle in the square is larger.
    double most = 0;
    /// Whether all of it is in the area.
    bool inside = false;
    std::size_t number = 0;
    /// The sides that may be the nearest of a place in it.
    std::vector<std::uint32_t> near = {};
    bool operator<(const Square& other) const {
      return std::pair(most, other.number) < std::pair(other.most, number);
    }
  };

  double least_wanted() const {
    const double larger = best_.radius + options_.precision;
    return std::isfinite(options_.enough) ? std::max(larger, options_.enough) : larger;
  }

  const BorderSide& side(std::uint32_t i) const {
    return i < border_.size() ? border_[i] : across_[i - border_.size()];
  }

  void divide(const Square& square) {
    const double half = 0.5 * square.half;
    for (const double dy : {-half, half}) {
      for (const double dx : {-half, half}) {
        look({.middle = square.middle + Vec2(dx, dy),
              .half = half,
              .inside = square.inside,
              .near = square.near});
      }
    }
  }

  /// Measures its middle, and keeps it where it may hold a larger disc.
  void look(Square square) {
    distances_.clear();
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : square.near) {
      distances_.push_back(distance_to(side(i), square.middle));
      nearest = std::min(nearest, distances_.back());
    }
    const double reach = std::numbers::sqrt2 * square.half;
    square.most = nearest + reach;
    if (square.most < least_wanted()) return;
    if (!square.inside && (nearest > reach || nearest > best_.radius)) {
      const bool inside = encloses(border_, square.middle);
      if (!inside && nearest > reach) return;
      square.inside = inside && nearest > reach;
      if (!inside) square.most = reach - nearest;
      if (inside && nearest > best_.radius) best_ = {square.middle, nearest};
    } else if (square.inside && nearest > best_.radius) {
      best_ = {square.middle, nearest};
    }
    if (square.most < least_wanted()) return;
    std::vector<std::uint32_t> near;
    for (std::size_t k = 0; k < distances_.size(); ++k) {
      if (distances_[k] <= nearest + 2 * reach) near.push_back(square.near[k]);
    }
    square.near = std::move(near);
    square.number = ++looked_at_;
    queue_.push(std::move(square));
  }

  std::span<const BorderSide> border_, across_;
  const DiscOptions& options_;
  std::priority_queue<Square> queue_;
  std::vector<double> distances_;
  std::size_t looked_at_ = 0;
  InnerDisc best_;
};

}  // namespace

bool encloses(std::span<const BorderSide> border, Vec2 p) {
  bool inside = false;
  for (const auto& [a, b] : border) {
    if (crosses_ray(a, b, p)) inside = !inside;
  }
  return inside;
}

double distance_to(const BorderSide& side, Vec2 p) {
  return distance_to_segment(side[0], side[1], p);
}

InnerDisc largest_disc(std::span<const BorderSide> border, std::span<const BorderSide> across,
                       const DiscOptions& options) {
  return Search(border, across, options).run();
}

}  // namespace burin
