#include <burin/annotate/place.h>
#include <burin/drawing/font.h>

#include "sides.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace burin {
namespace {

using detail::any_share, detail::deal, detail::lean, detail::places_of, detail::share_of,
    detail::sides_of;
using detail::Edge, detail::Left, detail::Right, detail::Bottom, detail::Top;
using detail::Place, detail::Side, detail::Sides, detail::Share;

/// Pairs that are looked at, of all passes: about a second. A hundred numbers take 5e5.
constexpr std::size_t kMostPairs = 30'000'000;

/// Changes places of pairs while that shortens their leaders. Ends: the sum falls each time by more
/// than rounding; `left` counts down, and what is not done at 0 stays.
std::size_t swap_pairs(std::span<const Vec2> anchors, Sides& sides, std::size_t& left,
                       const RunContext& context) {
  constexpr double kShorter = 1e-9;  // paper mm
  const std::vector<Place> places = all_places(sides);
  std::size_t swaps = 0;
  for (bool changed = true; changed && left > 0;) {
    changed = false;
    for (std::size_t i = 0; i < places.size() && left > 0; ++i) {
      context.check();
      left -= std::min(left, places.size() - i);
      for (std::size_t k = i + 1; k < places.size(); ++k) {
        std::size_t& a = sides[places[i].side].labels[places[i].index];
        std::size_t& b = sides[places[k].side].labels[places[k].index];
        const Vec2 p = sides[places[i].side].at(places[i].index);
        const Vec2 q = sides[places[k].side].at(places[k].index);
        const double now = glm::distance(anchors[a], p) + glm::distance(anchors[b], q);
        const double then = glm::distance(anchors[a], q) + glm::distance(anchors[b], p);
        if (then >= now - kShorter) continue;
        std::swap(a, b);
        changed = true;
        ++swaps;
      }
    }
  }
  return swaps;
}

void slide(std::span<const Vec2> anchors, double pitch, Sides& sides) {
  for (Side& side : sides) {
    std::vector<double> wanted;
    for (const std::size_t label : side.labels) {
      wanted.push_back(side.row ? anchors[label].x : anchors[label].y);
    }
    side.along = spread(wanted, pitch, side.low, side.high);
  }
}

/// How many leaders a leader crosses, anchors that it passes over, and circles; less for what of it
/// runs along strokes.
double conflicts(std::span<const Vec2> anchors, std::span<const Vec2> at, std::size_t own,
                 Vec2 place, double radius, const LeaderCosts& costs) {
  constexpr double kClear = 1.2;  // paper mm from another's dot
  constexpr double kCrossing = 100;
  // Paper mm that may run along strokes, and what is as bad as an anchor.
  constexpr double kLittle = 2, kAsBad = 40;
  double n = 0;
  const Vec2 from = anchors[own], way = place - from;
  const double square = glm::dot(way, way);
  const auto distance = [&](Vec2 p) {
    const double t = square > 0 ? std::clamp(glm::dot(p - from, way) / square, 0.0, 1.0) : 0;
    return glm::distance(p, from + t * way);
  };
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    if (i == own) continue;
    if (segments_cross(from, place, anchors[i], at[i])) n += kCrossing;
    if (distance(anchors[i]) < kClear) ++n;
    if (distance(at[i]) < radius) ++n;
  }
  const double mm = costs.along ? costs.along(from, place) : 0;
  if (mm > kLittle) n += mm / kAsBad;
  if (costs.over) n += costs.over(from, place);
  return n;
}

/// More numbers are not looked at one by one.
constexpr std::size_t kMostCleared = 1000;

/// Moves numbers whose leader passes over an anchor or a circle of another or over other
/// annotations, or runs along strokes, as far as their neighbours leave room.
void clear_anchors(std::span<const Vec2> anchors, const CalloutSizes& sizes, double pitch,
                   const LeaderCosts& costs, Sides& sides, const RunContext& context) {
  constexpr int kRounds = 4, kSteps = 12;
  const double radius = 0.5 * sizes.diameter;
  std::vector<Vec2> at = places_of(anchors.size(), sides);
  for (int round = 0; round < kRounds; ++round) {
    bool moved = false;
    context.check();
    for (Side& side : sides) {
      for (std::size_t i = 0; i < side.labels.size(); ++i) {
        const std::size_t own = side.labels[i];
        const double was = side.along[i];
        double least = conflicts(anchors, at, own, at[own], radius, costs);
        if (least == 0) continue;
        const double low = i > 0 ? side.along[i - 1] + pitch : side.low;
        const double high = i + 1 < side.along.size() ? side.along[i + 1] - pitch : side.high;
        double best = was;
        for (int step = 1; step <= kSteps && least > 0; ++step) {
          for (const double way : {-1.0, 1.0}) {
            side.along[i] = was + way * step * pitch / 4;
            if (side.along[i] < low || side.along[i] > high) continue;
            const double n = conflicts(anchors, at, own, side.at(i), radius, costs);
            if (n < least) least = n, best = side.along[i];
          }
        }
        side.along[i] = best;
        at[own] = side.at(i);
        moved |= best != was;
      }
    }
    if (!moved) return;
  }
}

bool any_crossing(std::span<const Vec2> anchors, std::span<const Vec2> at) {
  for (std::size_t i = 0; i < at.size(); ++i) {
    for (std::size_t k = i + 1; k < at.size(); ++k) {
      if (segments_cross(anchors[i], at[i], anchors[k], at[k])) return true;
    }
  }
  return false;
}

/// Numbers that stand on sides by a share.
struct Placed {
  std::vector<Vec2> at;
  std::size_t swaps = 0;
  bool unfinished = false;
};

Placed place_by(const Share& share, std::span<const Vec2> anchors, const Box2& drawing,
                const Box2& frame, const CalloutSizes& sizes, const LeaderCosts& costs,
                const RunContext& context) {
  Placed placed;
  Sides sides = sides_of(drawing, frame, sizes, share.corners);
  deal(anchors, share, sizes.pitch, sides);
  constexpr int kRounds = 12;
  std::size_t left = kMostPairs;
  placed.swaps = swap_pairs(anchors, sides, left, context);
  for (int round = 0; round < kRounds; ++round) {
    slide(anchors, sizes.pitch, sides);
    const std::size_t swaps = swap_pairs(anchors, sides, left, context);
    placed.swaps += swaps;
    if (swaps == 0) break;
  }
  placed.at = places_of(anchors.size(), sides);
  placed.unfinished = left == 0;
  if (anchors.size() > kMostCleared) return placed;
  clear_anchors(anchors, sizes, sizes.pitch, costs, sides, context);
  std::vector<Vec2> at = places_of(anchors.size(), sides);
  if (!any_crossing(anchors, at)) placed.at = std::move(at);
  return placed;
}

/// What is wrong with all leaders: what they meet, and how long they are.
double cost_of(std::span<const Vec2> anchors, std::span<const Vec2> at, double radius,
               const LeaderCosts& costs) {
  constexpr double kLong = 0.01;  // a mm
  double cost = 0;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    cost +=
        conflicts(anchors, at, i, at[i], radius, costs) + kLong * glm::distance(anchors[i], at[i]);
  }
  return cost;
}

/// Where leaders pass over other annotations: the best of the ways to share the numbers between
/// the two sides that have them.
void share_otherwise(Share share, std::span<const Vec2> anchors, const Box2& drawing,
                     const Box2& frame, const CalloutSizes& sizes, const LeaderCosts& costs,
                     const RunContext& context, Placed& best) {
  // More numbers fill both sides, and take longer.
  constexpr std::size_t kMost = 100, kWays = 5;
  const std::size_t n = anchors.size();
  auto& c = share.counts;
  const bool columns = c[Left] + c[Right] == n;
  if (!costs.over || n > kMost || (!columns && c[Top] + c[Bottom] != n)) return;
  const auto passes = [&](std::size_t i) { return costs.over(anchors[i], best.at[i]) > 0; };
  bool any = false;
  for (std::size_t i = 0; i < n && !any; ++i) any = passes(i);
  if (!any) return;
  const Edge first = columns ? Left : Top, second = columns ? Right : Bottom;
  const std::size_t room =
      std::min(n, sides_of(drawing, frame, sizes, share.corners)[first].room(sizes.pitch));
  const double radius = 0.5 * sizes.diameter;
  double least = cost_of(anchors, best.at, radius, costs);
  for (std::size_t k = 0; k < kWays && 2 * room >= n; ++k) {
    c[first] = std::clamp(n * k / (kWays - 1), n - room, room);
    c[second] = n - c[first];
    Placed other = place_by(share, anchors, drawing, frame, sizes, costs, context);
    const double cost = cost_of(anchors, other.at, radius, costs);
    if (!(cost < least - 1e-9)) continue;
    least = cost;
    best = std::move(other);
  }
}

}  // namespace

CalloutSizes::CalloutSizes(const CalloutOptions& options, int largest_number) {
  const double width = text_width(std::to_string(largest_number), options.height);
  diameter = options.circle ? std::max(2 * options.height, width + 0.3 * options.height)
                            : std::max(1.3 * options.height, width + 0.3 * options.height);
  pitch = 1.4 * diameter;
  gap = std::max(4.0, options.height);
}

bool segments_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) {
    const double s = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return s > 0 ? 1 : s < 0 ? -1 : 0;
  };
  const int u = side(a, b, c), v = side(a, b, d), w = side(c, d, a), x = side(c, d, b);
  if (u * v < 0 && w * x < 0) return true;
  const auto within = [](Vec2 p, Vec2 q, Vec2 r) {
    return r.x >= std::min(p.x, q.x) && r.x <= std::max(p.x, q.x) && r.y >= std::min(p.y, q.y) &&
           r.y <= std::max(p.y, q.y);
  };
  return (u == 0 && within(a, b, c)) || (v == 0 && within(a, b, d)) ||
         (w == 0 && within(c, d, a)) || (x == 0 && within(c, d, b));
}

std::vector<double> spread(std::span<const double> wanted, double pitch, double low, double high) {
  struct Block {
    double sum = 0;
    std::size_t count = 0;
    double mean() const { return sum / static_cast<double>(count); }
  };
  // In coordinates where the pitch is nothing, neighbours need only be in order.
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    blocks.push_back({wanted[i] - static_cast<double>(i) * pitch, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() >= blocks.back().mean()) {
      blocks[blocks.size() - 2].sum += blocks.back().sum;
      blocks[blocks.size() - 2].count += blocks.back().count;
      blocks.pop_back();
    }
  }
  std::vector<double> out;
  const double last = wanted.empty() ? 0 : static_cast<double>(wanted.size() - 1) * pitch;
  const double most = std::max(low, high - last);
  for (const Block& block : blocks) {
    const double at = std::clamp(block.mean(), low, most);
    for (std::size_t i = 0; i < block.count; ++i) {
      out.push_back(at + static_cast<double>(out.size()) * pitch);
    }
  }
  return out;
}

CalloutCapacity callout_capacity(const Box2& drawing, const Box2& frame,
                                 const CalloutSizes& sizes) {
  const Sides plain = sides_of(drawing, frame, sizes, false);
  return {plain[Left].room(sizes.pitch), plain[Top].room(sizes.pitch)};
}

bool callouts_fit(std::size_t count, const Box2& drawing, const Box2& frame,
                  const CalloutSizes& sizes, CalloutOptions::Layout layout) {
  return share_of(count, drawing, frame, sizes, layout).has_value();
}

CalloutPlaces place_callouts(std::span<const Vec2> anchors, const Box2& drawing, const Box2& frame,
                             const CalloutSizes& sizes, CalloutOptions::Layout layout,
                             const RunContext& context, const LeaderCosts& costs) {
  CalloutPlaces places;
  CalloutSizes used = sizes;
  std::optional<Share> share = share_of(anchors.size(), drawing, frame, used, layout);
  // How much larger, by steps of a fiftieth.
  constexpr double kLarger = 1.02, kMost = 1e3;
  for (double f = kLarger; !share && places.lacking == 1 && f < kMost; f *= kLarger) {
    const auto scaled = [&](const Box2& b) { return Box2{b.min * f, b.max * f}; };
    if (share_of(anchors.size(), scaled(drawing), scaled(frame), sizes, layout)) places.lacking = f;
  }
  // All are there, though closer, or over the drawing.
  for (int step = 0; !share && step < 400; ++step) {
    share = any_share(anchors.size(), drawing, frame, used, layout);
    if (!share) used.pitch *= 0.97;
  }
  if (!share) {
    share = Share{};
    share->counts[Left] = anchors.size();
  }
  places.pitch = used.pitch;
  lean(anchors, drawing, used.pitch, sides_of(drawing, frame, used, share->corners), *share);
  Placed placed = place_by(*share, anchors, drawing, frame, used, costs, context);
  share_otherwise(*share, anchors, drawing, frame, used, costs, context, placed);
  places.at = std::move(placed.at);
  places.swaps = placed.swaps;
  places.unfinished = placed.unfinished;
  return places;
}

}  // namespace burin
