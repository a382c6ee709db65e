#include "sides.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

namespace burin::detail {

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

namespace {

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

}  // namespace

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

std::optional<Share> share_of(std::size_t n, const Box2& drawing, const Box2& frame,
                              const CalloutSizes& sizes, CalloutOptions::Layout layout) {
  std::optional<Share> share = any_share(n, drawing, frame, sizes, layout);
  if (share && !has_space(*share, drawing, frame, sizes)) share.reset();
  return share;
}

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

std::vector<Place> all_places(const Sides& sides) {
  std::vector<Place> places;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    for (std::size_t i = 0; i < sides[s].labels.size(); ++i) places.push_back({s, i});
  }
  return places;
}

std::vector<Vec2> places_of(std::size_t count, const Sides& sides) {
  std::vector<Vec2> at(count);
  for (const Place& place : all_places(sides)) {
    const Side& side = sides[place.side];
    at[side.labels[place.index]] = side.at(place.index);
  }
  return at;
}

}  // namespace burin::detail
