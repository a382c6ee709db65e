#include <burin/annotate/dimensions.h>
#include <burin/drawing/font.h>

#include "frame_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {
namespace {

using detail::arrow_head, detail::line;

// Of the height of numbers: arrows; between a number and its line; how far extension lines go
// beyond the line.
constexpr double kArrow = 0.85, kBelowText = 0.25, kBeyond = 0.6;
// Paper mm between ink and the extension line that begins at it.
constexpr double kGap = 0.8;
/// Paper mm: ink that near is on an extension line.
constexpr double kOnLine = 0.05;

/// One dimension on paper.
class Laid {
 public:
  Laid(const Camera& camera, const Dimension& dimension, const DimensionOptions& style)
      : style_(style), text_(dimension.text) {
    ends_[0] = camera.to_paper(dimension.from);
    ends_[1] = camera.to_paper(dimension.to);
    along_ = glm::normalize(ends_[1] - ends_[0]);
    // The way outwards on paper, as the camera shows it at the middle.
    const Vec3 middle = 0.5 * (dimension.from + dimension.to);
    const double mm = 1 / camera.scale_at(middle);
    const Vec2 out = camera.to_paper(middle + mm * dimension.outwards) - camera.to_paper(middle);
    out_ = glm::normalize(out);
    const double across = std::abs(cross2(along_, out_));
    constexpr double kSquare = 1 - 1e-6;
    square_ = glm::length(out) > kSquare && across > kSquare;
    reach_ = dimension.distance / across;
  }

  void lay(const Drawing& drawing, Layer& layer) const {
    const double h = style_.height;
    Vec2 a = ends_[0] + reach_ * out_, b = ends_[1] + reach_ * out_;
    for (const Vec2& end : ends_) {
      const double start = ink_on(drawing, end) + kGap, stop = reach_ + kBeyond * h;
      if (start < stop)
        layer.paths.push_back(line(end + start * out_, end + stop * out_, style_.line));
    }
    const double length = glm::distance(a, b), width = text_width(text_, h);
    const double arrow = kArrow * h;
    const bool inside = length >= width + 2.5 * arrow, text_inside = length >= width + kBeyond * h;
    Vec2 middle = 0.5 * (a + b);
    if (inside) {
      layer.paths.push_back(line(a + 0.5 * arrow * along_, b - 0.5 * arrow * along_, style_.line));
    } else {
      // Arrows outside, and the number beyond them where it has no room between.
      const Vec2 to_right = reads_along() ? along_ : -along_;
      const double beyond = text_inside ? 0 : width + kBeyond * h;
      const Vec2 left = reads_along() ? a : b, right = reads_along() ? b : a;
      layer.paths.push_back(
          line(left - 2 * arrow * to_right, right + (2 * arrow + beyond) * to_right, style_.line));
      if (!text_inside) middle = right + (2 * arrow + 0.5 * beyond) * to_right;
    }
    layer.paths.push_back(arrow_head(a, inside ? -along_ : along_, arrow));
    layer.paths.push_back(arrow_head(b, inside ? along_ : -along_, arrow));
    layer.texts.push_back(number(middle));
  }

 private:
  /// Whether the number reads from `from` to `to`: to the right, or upwards.
  bool reads_along() const {
    constexpr double kUpright = 1e-9;
    return along_.x > kUpright || (along_.x > -kUpright && along_.y > 0);
  }

  Text number(Vec2 middle) const {
    const Vec2 way = reads_along() ? along_ : -along_, up(-way.y, way.x);
    Text text{middle + kBelowText * style_.height * up,
              style_.height,
              TextAnchor::Middle,
              text_,
              "dimension",
              0};
    text.turn = glm::degrees(std::atan2(way.y, way.x));
    // Quarters are exact, so that they are the same on any machine.
    constexpr double kRounded = 1e-6;  // degrees
    const double quarters = std::round(text.turn / 90) * 90;
    if (std::abs(text.turn - quarters) < kRounded) text.turn = quarters;
    return text;
  }

  /// How far out the last ink is that lies on the extension line from an end; 0 where there is
  /// none. In a view that is square to both, what is there may be less far out than the end.
  double ink_on(const Drawing& drawing, Vec2 end) const {
    std::optional<double> last;
    if (!square_) last = 0;
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        if (!path.visible) continue;
        for (const Vec2& p : path.points) {
          const Vec2 to = p - end;
          const double out = glm::dot(to, out_);
          if (out > reach_ || std::abs(cross2(to, out_)) > kOnLine) continue;
          last = last ? std::max(*last, out) : out;
        }
      }
    }
    return last.value_or(0);
  }

  const DimensionOptions& style_;
  const std::string& text_;
  Vec2 ends_[2], along_{1, 0}, out_{0, 1};
  double reach_ = 0;
  bool square_ = false;
};

}  // namespace

std::vector<OptionRow<DimensionOptions>> dimension_option_rows() {
  using options::number;
  OptionRow<DimensionOptions> decimals{
      {"decimals", "places after the point of dimensions; zeros at the end are left out",
       WholeRange{0, 6}},
      [](const DimensionOptions& s) { return OptionValue(s.decimals); },
      [](DimensionOptions& s, const OptionValue& v) { s.decimals = std::get<std::uint64_t>(v); }};
  return {
      number("height", &DimensionOptions::height, {1, 50, "mm"},
             "height of the numbers of dimensions, in mm"),
      number("line", &DimensionOptions::line, {0.01, 10, "mm"},
             "width of the lines of dimensions, in mm"),
      std::move(decimals),
      options::word("sign", &DimensionOptions::sign, {"point", "comma"},
                    "the sign before the decimals of dimensions"),
  };
}

std::string dimension_text(double length, const DimensionOptions& style) {
  std::string text = fmt::format("{:.{}f}", length, static_cast<int>(style.decimals));
  if (style.decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  if (style.sign == DimensionOptions::Sign::Comma) std::ranges::replace(text, '.', ',');
  return text;
}

DimensionReach dimension_reach(const DimensionOptions& style) {
  // Text, its gap and as much again keep the line off the drawing.
  return {.line = 2.4 * style.height, .end = (1 + 2 * kBelowText) * style.height};
}

void lay_dimensions(Drawing& drawing, const Camera& camera, std::span<const Dimension> dimensions,
                    const DimensionOptions& style) {
  if (dimensions.empty()) return;
  Layer layer{"dimensions", {}};
  for (const Dimension& dimension : dimensions) {
    Laid(camera, dimension, style).lay(drawing, layer);
  }
  const Box2 sheet{Vec2(0), {drawing.paper_width, drawing.paper_height}};
  const auto cut = std::ranges::count_if(layer.texts, [&](const Text& text) {
    const Box2 box = text_box(text);
    return !sheet.contains(box.min) || !sheet.contains(box.max);
  });
  if (cut > 0) {
    drawing.diagnostics.add(Severity::Warning, "dimensions.off_sheet", cut,
                            "numbers of dimensions run off the sheet: a larger `paper` or smaller "
                            "`dimension.height` has room for them");
  }
  drawing.layers.push_back(std::move(layer));
}

}  // namespace burin
