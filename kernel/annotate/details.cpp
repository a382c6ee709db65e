#include <burin/annotate/details.h>
#include <burin/drawing/font.h>
#include <burin/drawing/length.h>

#include "frame_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

using detail::line;

constexpr double kAbove = 0.4;  // of the height of letters: between a circle and its letter
// The symbol, paper mm: the diameters of the truncated cone and its length (1:2 and as long as the
// larger), its two views this far apart.
constexpr double kSmall = 4, kLarge = 8, kLength = 8, kViewsApart = 4;
// Paper mm that centre lines stand out.
constexpr double kOut = 1.5;

/// Paper mm of ink of a drawing in a box.
double ink_in(const Drawing& drawing, const Box2& box) {
  double length = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      Box2 reach;
      for (const Vec2& p : path.points) reach.add(p);
      if (reach.empty() || !reach.overlaps(box)) continue;
      for (const Path& piece : clipped(path, box)) length += length_of(piece);
    }
  }
  return length;
}

/// Where letters stand already.
double overlaps_in(std::span<const Box2> taken, const Box2& box) {
  constexpr double kInsteadOfInk = 1e6;  // paper mm: no letter over another
  return kInsteadOfInk * static_cast<double>(std::ranges::count_if(
                             taken, [&](const Box2& other) { return other.overlaps(box); }));
}

/// Beside the circle, from the upper right on round it, where it meets least ink and is on the
/// sheet.
Box2 letter_box(const Drawing& sheet, const DetailMark& mark, double height,
                std::span<const Box2> taken) {
  constexpr int kPlaces = 16;
  const Vec2 half = 0.5 * Vec2(text_width(mark.letter, height), height);
  const double reach = mark.from.radius + kAbove * height + glm::length(half);
  Box2 best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPlaces; ++i) {
    const double a = std::numbers::pi * (0.25 + 2.0 * i / kPlaces);
    const Vec2 middle = mark.from.center + reach * Vec2(std::cos(a), std::sin(a));
    const Box2 box{middle - half, middle + half};
    const bool outside = box.min.x < 0 || box.min.y < 0 || box.max.x > sheet.paper_width ||
                         box.max.y > sheet.paper_height;
    if (outside && !best.empty()) continue;
    const double ink = ink_in(sheet, box) + overlaps_in(taken, box);
    if (ink < least || best.empty()) least = outside ? least : ink, best = box;
  }
  return best;
}

}  // namespace

std::vector<Vec2> line_of(const DetailMark& mark) {
  std::vector<Vec2> ring = detail::circle(mark.from.center, mark.from.radius, 0).points;
  ring.push_back(ring.front());
  return ring;
}

double detail_caption(const CalloutOptions& style) { return (1 + 2 * kAbove) * style.height; }

void lay_details(Drawing& sheet, std::span<const DetailMark> marks, const CalloutOptions& style) {
  Layer layer{"details", {}};
  for (const DetailMark& mark : marks) {
    for (const Disc& disc : {mark.from, mark.to}) {
      layer.paths.push_back(detail::circle(disc.center, disc.radius, style.line));
    }
  }
  sheet.layers.push_back(std::move(layer));
  std::vector<Box2> taken;
  for (const Layer& other : sheet.layers) {
    for (const Text& text : other.texts) taken.push_back(text_box(text));
  }
  std::vector<Text> captions, texts;
  for (const DetailMark& mark : marks) {
    const Vec2 above(0, mark.to.radius + kAbove * style.height);
    captions.push_back({mark.to.center + above, style.height, TextAnchor::Middle,
                        mark.letter + " (" + scale_text(mark.scale) + ")", "detail", 0});
    taken.push_back(text_box(captions.back()));
  }
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const DetailMark& mark = marks[i];
    const Box2 box = letter_box(sheet, mark, style.height, taken);
    taken.push_back(box);
    texts.push_back(
        {{box.center().x, box.min.y}, style.height, TextAnchor::Middle, mark.letter, "detail", 0});
    texts.push_back(std::move(captions[i]));
  }
  sheet.layers.back().texts = std::move(texts);
}

Vec2 projection_symbol_size() {
  return {kLength + kViewsApart + kLarge + 2 * kOut, kLarge + 2 * kOut};
}

Layer projection_symbol(ProjectionMethod method, Vec2 at, const CalloutOptions& style) {
  Layer layer{"projection", {}};
  const double thick = 2 * style.line, y = at.y + kOut + 0.5 * kLarge;
  // In third angle the view along the axis, of the small end, stands where that end is: the cone
  // points to it. In first angle it stands on the other side.
  const bool third = method == ProjectionMethod::ThirdAngle;
  const double circles =
      at.x + kOut + (third ? 0.5 * kLarge : kLength + kViewsApart + 0.5 * kLarge);
  const double left = at.x + kOut + (third ? kLarge + kViewsApart : 0);
  Path cone = line({left, y - 0.5 * kSmall}, {left + kLength, y - 0.5 * kLarge}, thick);
  cone.points.insert(cone.points.end(),
                     {{left + kLength, y + 0.5 * kLarge}, {left, y + 0.5 * kSmall}});
  cone.closed = true;
  layer.paths.push_back(std::move(cone));
  layer.paths.push_back(detail::circle({circles, y}, 0.5 * kSmall, thick));
  layer.paths.push_back(detail::circle({circles, y}, 0.5 * kLarge, thick));
  layer.paths.push_back(line({left - kOut, y}, {left + kLength + kOut, y}, style.line));
  const double reach = 0.5 * kLarge + kOut;
  layer.paths.push_back(line({circles - reach, y}, {circles + reach, y}, style.line));
  layer.paths.push_back(line({circles, y - reach}, {circles, y + reach}, style.line));
  return layer;
}

}  // namespace burin
