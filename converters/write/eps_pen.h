#pragma once
// Places and colours of PostScript; internal to the module.

#include <burin/base/vec.h>
#include <burin/drawing/bezier.h>
#include <burin/drawing/color.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/text.h>

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace burin {

inline constexpr double kUnitsPerMm = 1000;

inline std::string eps_color(const std::string& text) {
  if (text == Drawing().ink_color) return "0 setgray";
  const Rgb rgb = rgb_of(text).value_or(Rgb{});
  return fmt::format("{:.4f} {:.4f} {:.4f} setrgbcolor", rgb[0] / 255.0, rgb[1] / 255.0,
                     rgb[2] / 255.0);
}

/// Steps between places on the grid of micrometres.
class EpsPen {
 public:
  explicit EpsPen(Buffer& out) : out_(out) {}

  void move(Vec2 p) {
    at_ = place(p);
    fmt::format_to(fmt::appender(out_), "{} {} m\n", at_.x, at_.y);
  }
  void line(Vec2 p) {
    step(place(p));
    at_ = place(p);
    append(out_, "l\n");
  }
  void curve(const CubicBezier& c) {
    for (int i = 1; i < 4; ++i) step(place(c[static_cast<std::size_t>(i)]));
    at_ = place(c[3]);
    append(out_, "c\n");
  }

 private:
  struct Place {
    std::int64_t x = 0, y = 0;
  };
  static Place place(Vec2 p) {
    return {std::llround(p.x * kUnitsPerMm), std::llround(p.y * kUnitsPerMm)};
  }
  void step(Place to) { fmt::format_to(fmt::appender(out_), "{} {} ", to.x - at_.x, to.y - at_.y); }

  Buffer& out_;
  Place at_;
};

}  // namespace burin
