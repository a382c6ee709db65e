#include <burin/options/declared.h>
#include <burin/options/row.h>

#include "frame_path.h"
#include "own_symbols.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

using Ring = std::vector<Vec2>;

/// The safety colours of ISO 3864, as RAL 1003, 5005 and 3001 have them, and their contrasts.
constexpr const char* kYellow = "#f9a800";
constexpr const char* kBlue = "#005387";
constexpr const char* kRed = "#9b2423";
constexpr const char* kBlack = "#000000";
constexpr const char* kWhite = "#ffffff";

Ring disc(Vec2 center, double radius) { return circle(center, radius, 0).points; }

/// A regular triangle on its side, with round corners, inside a square of side 1.
Ring triangle(double inset, double corner) {
  const double height = 0.5 * std::numbers::sqrt3;
  const Vec2 middle(0.5, height / 3);
  const double reach = 2 * height / 3 - 2 * inset - 2 * corner;  // of the corners' middles
  Ring out;
  constexpr int kSteps = 12;
  for (int side = 0; side < 3; ++side) {
    const double way = glm::radians(90.0 + 120 * side);
    const Vec2 at = middle + reach * Vec2(std::cos(way), std::sin(way));
    for (int k = 0; k <= kSteps; ++k) {
      const double turn = way + glm::radians(120.0 * k / kSteps - 60);
      out.push_back(at + corner * Vec2(std::cos(turn), std::sin(turn)));
    }
  }
  return out;
}

/// An exclamation mark about a middle, of that height.
std::vector<Ring> exclamation(Vec2 middle, double height) {
  const double dot = 0.09 * height, top = 0.5 * height;
  const Ring stroke{middle + Vec2(-0.09, 0.5) * height, middle + Vec2(-0.055, -0.2) * height,
                    middle + Vec2(0.055, -0.2) * height, middle + Vec2(0.09, 0.5) * height};
  return {stroke, disc(middle + Vec2(0, dot - top), dot)};
}

/// A flash.
std::vector<Ring> flash(Vec2 middle, double height) {
  Ring out{{0.1, 0.5},    {-0.2, -0.05}, {0.02, -0.02}, {-0.06, -0.33}, {-0.13, -0.3},
           {-0.04, -0.5}, {0.12, -0.32}, {0.04, -0.33}, {0.2, 0.1},     {-0.03, 0.07}};
  for (Vec2& p : out) p = middle + height * p;
  return {out};
}

/// Warmth that rises from a plate.
std::vector<Ring> waves(Vec2 middle, double height) {
  std::vector<Ring> out;
  constexpr int kSteps = 16;
  const double half = 0.035;
  for (const double x : {-0.22, 0.0, 0.22}) {
    Ring left, right;
    for (int k = 0; k <= kSteps; ++k) {
      const double y = -0.22 + 0.62 * k / kSteps;
      const double sway = 0.07 * std::sin(2 * std::numbers::pi * k / kSteps);
      left.push_back(middle + height * Vec2(x + sway - half, y));
      right.push_back(middle + height * Vec2(x + sway + half, y));
    }
    left.insert(left.end(), right.rbegin(), right.rend());
    out.push_back(std::move(left));
  }
  out.push_back({middle + height * Vec2(-0.42, -0.4), middle + height * Vec2(0.42, -0.4),
                 middle + height * Vec2(0.42, -0.3), middle + height * Vec2(-0.42, -0.3)});
  return out;
}

/// An open book.
std::vector<Ring> book(Vec2 middle, double height) {
  std::vector<Ring> out;
  for (const double side : {-1.0, 1.0}) {
    Ring page{{0.03, -0.3}, {0.48, -0.22}, {0.48, 0.3}, {0.03, 0.22}};
    for (Vec2& p : page) p = middle + height * Vec2(side * p.x, p.y);
    out.push_back(std::move(page));
  }
  return out;
}

void fill(std::vector<Ring> rings, const char* color, double size, Label& out) {
  for (Ring& ring : rings) {
    for (Vec2& p : ring) p *= size;
  }
  Area area;
  area.fill = color;
  area.rings = std::move(rings);
  out.areas.push_back(std::move(area));
}

template <class Sign>
Label begun(const Sign& sign, double height) {
  Label out;
  out.size = {sign.size, height * sign.size};
  out.shoulder = 0.5 * out.size.y;
  return out;
}

template <class Sign>
OptionRow<Sign> size_row() {
  return options::number("size", &Sign::size, {2, 200, "mm"}, "how wide the sign is, in mm");
}

struct WarningSign {
  static constexpr const char* kRow = "warning";
  enum class Of { General, Electricity, Hot };
  Of of = Of::General;
  double size = 12;
  static std::vector<OptionRow<WarningSign>> rows() {
    return {options::word("of", &WarningSign::of, {"general", "electricity", "hot"},
                          "what it warns of"),
            size_row<WarningSign>()};
  }
};

Label draw_warning(const SymbolRequest& request) {
  const auto sign = values_in<WarningSign>(request.values);
  Label out = begun(sign, 0.5 * std::numbers::sqrt3);
  constexpr double kCorner = 0.05, kBorder = 0.045;
  fill({triangle(0, kCorner)}, kBlack, sign.size, out);
  fill({triangle(kBorder, 0.5 * kCorner)}, kYellow, sign.size, out);
  const Vec2 middle(0.5, 0.3);
  std::vector<Ring> of = sign.of == WarningSign::Of::Electricity ? flash(middle, 0.46)
                         : sign.of == WarningSign::Of::Hot       ? waves(middle, 0.4)
                                                                 : exclamation(middle, 0.42);
  fill(std::move(of), kBlack, sign.size, out);
  put_beside(request.text, request.pens, out);
  return out;
}

struct MandatorySign {
  static constexpr const char* kRow = "mandatory";
  enum class Of { General, Manual };
  Of of = Of::General;
  double size = 12;
  static std::vector<OptionRow<MandatorySign>> rows() {
    return {options::word("of", &MandatorySign::of, {"general", "manual"}, "what must be done"),
            size_row<MandatorySign>()};
  }
};

Label draw_mandatory(const SymbolRequest& request) {
  const auto sign = values_in<MandatorySign>(request.values);
  Label out = begun(sign, 1);
  fill({disc(Vec2(0.5), 0.5)}, kBlue, sign.size, out);
  fill(sign.of == MandatorySign::Of::Manual ? book(Vec2(0.5), 0.7) : exclamation(Vec2(0.5), 0.66),
       kWhite, sign.size, out);
  put_beside(request.text, request.pens, out);
  return out;
}

struct ProhibitionSign {
  static constexpr const char* kRow = "prohibition";
  double size = 12;
  static std::vector<OptionRow<ProhibitionSign>> rows() { return {size_row<ProhibitionSign>()}; }
};

Label draw_prohibition(const SymbolRequest& request) {
  const auto sign = values_in<ProhibitionSign>(request.values);
  Label out = begun(sign, 1);
  // A tenth of the diameter, and 0.08 of it across, from the upper left to the lower right.
  constexpr double kBand = 0.1, kBar = 0.04;
  fill({disc(Vec2(0.5), 0.5)}, kRed, sign.size, out);
  fill({disc(Vec2(0.5), 0.5 - kBand)}, kWhite, sign.size, out);
  const Vec2 along = (0.5 - 0.5 * kBand) * Vec2(1, -1) / std::numbers::sqrt2;
  const Vec2 across = kBar * Vec2(1, 1) / std::numbers::sqrt2, middle(0.5);
  fill({{middle - along - across, middle + along - across, middle + along + across,
         middle - along + across}},
       kRed, sign.size, out);
  put_beside(request.text, request.pens, out);
  return out;
}

}  // namespace

SymbolKind warning_symbol() {
  return {"warning", "a sign of warning, its text beside", draw_warning, declared<WarningSign>()};
}

SymbolKind mandatory_symbol() {
  return {"mandatory", "a sign of what must be done, its text beside", draw_mandatory,
          declared<MandatorySign>()};
}

SymbolKind prohibition_symbol() {
  return {"prohibition", "a sign of what is forbidden, its text beside", draw_prohibition,
          declared<ProhibitionSign>()};
}

}  // namespace burin::detail
