#include <burin/annotate/place.h>
#include <burin/drawing/font.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace burin {
namespace {

/// A side of the rectangle: a line along x (rows) or y (columns).
struct Side {
  bool row = false;
  /// The other coordinate, and from where to where middles may stand.
  double across = 0, low = 0, high = 0;
  /// Anchors by place along the side.
  std::vector<std::size_t> labels;
  std::vector<double> along;

  Vec2 at(std::size_t i) const { return row ? Vec2(along[i], across) : Vec2(across, along[i]); }
  std::size_t room(double pitch) const {
    return high < low ? 0 : static_cast<std::size_t>((high - low) / pitch + 1e-9) + 1;
  }
};

enum Edge : std::size_t { Left, Right, Bottom, Top };
using Sides = std::array<Side, 4>;

Sides sides_of(const Box2& drawing, const Box2& frame, const CalloutSizes& sizes, bool corners) {
  const double r = 0.5 * sizes.diameter, off = sizes.gap + r;
  Sides sides;
  sides[Left].across = std::max(drawing.min.x - off, frame.min.x + r);
  sides[Right].across = std::min(drawing.max.x + off, frame.max.x - r);
  sides[Bottom].across = std::max(drawing.min.y - off, frame.min.y + r);
  sides[Top].across = std::min(drawing.max.y + off, frame.max.y - r);
  for (const std::size_t column : {Left, Right}) {
    sides[column].low = corners ? sides[Bottom].across + sizes.pitch : frame.min.y + r;
    sides[column].high = corners ? sides[Top].across - sizes.pitch : frame.max.y - r;
  }
  for (const std::size_t row : {Bottom, Top}) {
    sides[row].row = true;
    sides[row].low = sides[Left].across;
    sides[row].high = sides[Right].across;
  }
  return sides;
}

/// How many numbers each side gets.
struct Share {
  bool corners = false;
  std::array<std::size_t, 4> counts{};
};

/// Whether the numbers of a share stand beside the drawing, not over it.
bool has_space(const Share& share, const Box2& drawing, const Box2& frame,
               const CalloutSizes& sizes) {
  constexpr double kRounding = 1e-6;  // paper mm
  const double r = 0.5 * sizes.diameter - kRounding;
  const Sides sides = sides_of(drawing, frame, sizes, share.corners);
  const auto& c = share.counts;
  const bool columns = c[Left] + c[Right] > 0, rows = c[Bottom] + c[Top] > 0;
  return (!columns ||
          (sides[Left].across + r <= drawing.min.x && sides[Right].across - r >= drawing.max.x)) &&
         (!rows ||
          (sides[Bottom].across + r <= drawing.min.y && sides[Top].across - r >= drawing.max.y));
}

std::optional<Share> any_share(std::size_t n, const Box2& drawing, const Box2& frame,
                               const CalloutSizes& sizes, CalloutOptions::Layout layout) {
  using Layout = CalloutOptions::Layout;
  const auto halves = [](std::size_t m) { return std::pair(m - m / 2, m / 2); };
  Share share;
  auto& c = share.counts;
  if (layout == Layout::Columns) {
    const Sides plain = sides_of(drawing, frame, sizes, false);
    if (n <= 2 * plain[Left].room(sizes.pitch)) {
      std::tie(c[Left], c[Right]) = halves(n);
      return share;
    }
  }
  share.corners = true;
  const Sides sides = sides_of(drawing, frame, sizes, true);
  const std::size_t column = sides[Left].room(sizes.pitch), row = sides[Top].room(sizes.pitch);
  if (n > 2 * (column + row)) return std::nullopt;
  std::size_t rows = 0;
  if (layout == Layout::Columns) {
    rows = n - std::min(n, 2 * column);
  } else if (layout == Layout::Rows) {
    rows = std::min(n, 2 * row);
  } else {
    const double wide = drawing.size().x, tall = drawing.size().y;
    const double part = wide + tall > 0 ? wide / (wide + tall) : 0.5;
    rows = static_cast<std::size_t>(std::lround(part * static_cast<double>(n)));
    rows = std::clamp(rows, n - std::min(n, 2 * column), std::min(n, 2 * row));
  }
  std::tie(c[Top], c[Bottom]) = halves(rows);
  std::tie(c[Left], c[Right]) = halves(n - rows);
  return share;
}

/// The share that leaves the drawing clear; nothing where there is none.
std::optional<Share> share_of(std::size_t n, const Box2& drawing, const Box2& frame,
                              const CalloutSizes& sizes, CalloutOptions::Layout layout) {
  std::optional<Share> share = any_share(n, drawing, frame, sizes, layout);
  if (share && !has_space(*share, drawing, frame, sizes)) share.reset();
  return share;
}

/// Where all numbers stand on two opposite sides, those go to each whose anchors are nearer to it,
/// as far as both have room.
void lean(std::span<const Vec2> anchors, const Box2& drawing, double pitch, const Sides& sides,
          Share& share) {
  auto& c = share.counts;
  const std::size_t n = anchors.size();
  const auto part = [&](std::size_t first, std::size_t second, const auto& nearer) {
    const std::size_t room = std::min(n, sides[first].room(pitch));
    const auto count = static_cast<std::size_t>(std::ranges::count_if(anchors, nearer));
    c[first] = std::clamp(count, n - room, room);
    c[second] = n - c[first];
  };
  const Vec2 middle = drawing.center();
  if (c[Left] + c[Right] == n && n <= 2 * sides[Left].room(pitch)) {
    part(Left, Right, [&](Vec2 p) { return p.x < middle.x; });
  } else if (c[Top] + c[Bottom] == n && n <= 2 * sides[Top].room(pitch)) {
    part(Top, Bottom, [&](Vec2 p) { return p.y > middle.y; });
  }
}

/// Deals the anchors to the sides: those farthest up, down, left, then the rest; each side by
/// place.
void deal(std::span<const Vec2> anchors, const Share& share, double pitch, Sides& sides) {
  std::vector<std::size_t> left(anchors.size());
  std::iota(left.begin(), left.end(), std::size_t{0});
  const auto take = [&](std::size_t side, const auto& key) {
    std::ranges::stable_sort(left, {}, key);
    const auto end = left.begin() + static_cast<std::ptrdiff_t>(share.counts[side]);
    sides[side].labels.assign(left.begin(), end);
    left.erase(left.begin(), end);
  };
  take(Top, [&](std::size_t i) { return -anchors[i].y; });
  take(Bottom, [&](std::size_t i) { return anchors[i].y; });
  take(Left, [&](std::size_t i) { return anchors[i].x; });
  take(Right, [&](std::size_t i) { return anchors[i].x; });
  for (Side& side : sides) {
    const auto along = [&](std::size_t i) { return side.row ? anchors[i].x : anchors[i].y; };
    std::ranges::stable_sort(side.labels, {}, along);
    std::vector<double> wanted;
    for (const std::size_t label : side.labels) wanted.push_back(along(label));
    side.along = spread(wanted, pitch, side.low, side.high);
  }
}

/// All places as one list: who stands where.
struct Place {
  std::size_t side, index;
};

std::vector<Place> all_places(const Sides& sides) {
  std::vector<Place> places;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    for (std::size_t i = 0; i < sides[s].labels.size(); ++i) places.push_back({s, i});
  }
  return places;
}

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
                 Vec2 place, double radius, const AlongStrokes& along) {
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
  if (const double mm = along ? along(from, place) : 0; mm > kLittle) n += mm / kAsBad;
  return n;
}

/// More numbers are not looked at one by one.
constexpr std::size_t kMostCleared = 1000;

std::vector<Vec2> places_of(std::size_t count, const Sides& sides) {
  std::vector<Vec2> at(count);
  for (const Place& place : all_places(sides)) {
    const Side& side = sides[place.side];
    at[side.labels[place.index]] = side.at(place.index);
  }
  return at;
}

/// Moves numbers whose leader passes over an anchor or a circle of another, or runs along strokes,
/// as far as their neighbours leave room.
void clear_anchors(std::span<const Vec2> anchors, const CalloutSizes& sizes, double pitch,
                   const AlongStrokes& along, Sides& sides, const RunContext& context) {
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
        double least = conflicts(anchors, at, own, at[own], radius, along);
        if (least == 0) continue;
        const double low = i > 0 ? side.along[i - 1] + pitch : side.low;
        const double high = i + 1 < side.along.size() ? side.along[i + 1] - pitch : side.high;
        double best = was;
        for (int step = 1; step <= kSteps && least > 0; ++step) {
          for (const double way : {-1.0, 1.0}) {
            side.along[i] = was + way * step * pitch / 4;
            if (side.along[i] < low || side.along[i] > high) continue;
            const double n = conflicts(anchors, at, own, side.at(i), radius, along);
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
                             const RunContext& context, const AlongStrokes& along) {
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
  Sides sides = sides_of(drawing, frame, used, share->corners);
  lean(anchors, drawing, used.pitch, sides, *share);
  deal(anchors, *share, used.pitch, sides);
  constexpr int kRounds = 12;
  std::size_t left = kMostPairs;
  places.swaps = swap_pairs(anchors, sides, left, context);
  for (int round = 0; round < kRounds; ++round) {
    slide(anchors, used.pitch, sides);
    const std::size_t swaps = swap_pairs(anchors, sides, left, context);
    places.swaps += swaps;
    if (swaps == 0) break;
  }
  places.at = places_of(anchors.size(), sides);
  places.unfinished = left == 0;
  if (anchors.size() > kMostCleared) return places;
  Sides cleared = sides;
  clear_anchors(anchors, used, used.pitch, along, cleared, context);
  std::vector<Vec2> at = places_of(anchors.size(), cleared);
  if (!any_crossing(anchors, at)) places.at = std::move(at);
  return places;
}

}  // namespace burin
