#include "kept_clear.h"

#include <burin/annotate/place.h>
#include <burin/drawing/font.h>

#include <algorithm>
#include <cstddef>

namespace burin::detail {
namespace {

/// Whether a leader passes over letters.
bool passes_over(const Box2& letters, Vec2 from, Vec2 to) {
  const Vec2 a = letters.min, c = letters.max, b(c.x, a.y), d(a.x, c.y);
  return letters.contains(from) || letters.contains(to) || segments_cross(from, to, a, c) ||
         segments_cross(from, to, b, d);
}

using Pieces = std::vector<std::pair<Vec2, Vec2>>;

void add_pieces(std::span<const Vec2> points, bool closed, Pieces& pieces) {
  const std::size_t n = points.size();
  for (std::size_t i = closed ? 0 : 1; i < n; ++i) {
    const Vec2 before = points[(i + n - 1) % n];
    if (before != points[i]) pieces.emplace_back(before, points[i]);
  }
}

void add_lines(const Layer& layer, Pieces& pieces) {
  for (const Path& path : layer.paths) add_pieces(path.points, path.closed, pieces);
}

}  // namespace

KeptClear::KeptClear(const Drawing& drawing, std::span<const std::vector<Vec2>> later) {
  for (const Layer& layer : drawing.layers) {
    for (const Text& text : layer.texts) letters_.push_back(text_box(text));
    if (layer.name == "dimensions") add_lines(layer, dimensions_);
    if (layer.name == "notes") add_lines(layer, others_);
  }
  for (const std::vector<Vec2>& line : later) add_pieces(line, false, others_);
}

double KeptClear::passed_over(Vec2 from, Vec2 to) const {
  // A leader over another is taken for a part of it; lines of dimensions may be crossed at need.
  constexpr double kLetters = 5, kOther = 3, kDimension = 1;
  const auto crossed = [&](const std::pair<Vec2, Vec2>& piece) {
    return segments_cross(from, to, piece.first, piece.second);
  };
  const auto over =
      std::ranges::count_if(letters_, [&](const Box2& box) { return passes_over(box, from, to); });
  return kLetters * static_cast<double>(over) +
         kOther * static_cast<double>(std::ranges::count_if(others_, crossed)) +
         kDimension * static_cast<double>(std::ranges::count_if(dimensions_, crossed));
}

}  // namespace burin::detail
