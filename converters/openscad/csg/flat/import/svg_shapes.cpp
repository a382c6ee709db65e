#include "svg_shapes.h"

#include <burin/base/error.h>

#include "fragments.h"
#include "text.h"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>

namespace burin::csg {
namespace {

bool separates(char c) { return is_blank(c) || is_line_end(c) || c == ','; }

/// One word of a transform; those with a wrong count of numbers do nothing.
Affine one_transform(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return {{v[0], v[1]}, {v[2], v[3]}, {v[4], v[5]}};
  if (name == "translate" && (n == 1 || n == 2)) {
    return {{1, 0}, {0, 1}, {v[0], n > 1 ? v[1] : 0}};
  }
  if (name == "scale" && (n == 1 || n == 2)) return {{v[0], 0}, {0, n > 1 ? v[1] : v[0]}, {0, 0}};
  if (name == "rotate" && (n == 1 || n == 3)) {
    const Vec2 d = direction(v[0]), about = n == 3 ? Vec2(v[1], v[2]) : Vec2(0);
    return Affine{{1, 0}, {0, 1}, about} * Affine{d, {-d.y, d.x}, {0, 0}} *
           Affine{{1, 0}, {0, 1}, -about};
  }
  const double slope = n == 1 ? std::tan(v[0] * M_PI / 180) : 0;
  if (name == "skewX") return {{1, 0}, {slope, 1}, {0, 0}};
  if (name == "skewY") return {{1, slope}, {0, 1}, {0, 0}};
  return {};
}

}  // namespace

Affine svg_transform(std::string_view text) {
  Affine out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t open = text.find('(', at);
    if (open == std::string_view::npos) break;
    const std::size_t close = std::min(text.find(')', open), text.size());
    std::string_view name = text.substr(at, open - at);
    while (!name.empty() && separates(name.front())) name.remove_prefix(1);
    while (!name.empty() && separates(name.back())) name.remove_suffix(1);
    out = out * one_transform(name, svg_numbers(text.substr(open + 1, close - open - 1)));
    at = close + 1;
  }
  return out;
}

double svg_number(std::string_view text) {
  double value = 0;
  return parse_double(text, value) && std::isfinite(value) ? value : 0;
}

std::vector<double> svg_numbers(std::string_view text) {
  std::vector<double> out;
  while (!text.empty()) {
    std::size_t length = 0;
    while (length < text.size() && !separates(text[length])) ++length;
    if (length > 0) out.push_back(svg_number(text.substr(0, length)));
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return out;
}

std::vector<Outline> stroked(const std::vector<Vec2>& path, const SvgStroke& stroke) {
  // OpenSCAD's grid here, in user units.
  constexpr double kUnits = 10000, kFarthest = 1e12;
  ClipperLib::Path line;
  for (const Vec2& p : path) {
    if (!(std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest)) {
      throw InputError("an SVG line with a point that is no number or beyond 1e12");
    }
    line.emplace_back(static_cast<ClipperLib::cInt>(p.x * kUnits),
                      static_cast<ClipperLib::cInt>(p.y * kUnits));
  }
  const auto join = stroke.join == SvgStroke::Join::Round   ? ClipperLib::jtRound
                    : stroke.join == SvgStroke::Join::Bevel ? ClipperLib::jtSquare
                                                            : ClipperLib::jtMiter;
  const auto cap = stroke.cap == SvgStroke::Cap::Butt    ? ClipperLib::etOpenButt
                   : stroke.cap == SvgStroke::Cap::Round ? ClipperLib::etOpenRound
                                                         : ClipperLib::etOpenSquare;
  ClipperLib::ClipperOffset clipper;
  clipper.AddPath(line, join, cap);
  ClipperLib::Paths result;
  clipper.Execute(result, std::min(stroke.width, kFarthest) * kUnits / 2);
  std::vector<Outline> out;
  for (const ClipperLib::Path& p : result) {
    Outline& outline = out.emplace_back();
    for (const ClipperLib::IntPoint& q : p) {
      outline.points.emplace_back(static_cast<double>(q.X) / kUnits,
                                  static_cast<double>(q.Y) / kUnits);
    }
    outline.arc.assign(outline.points.size(), -1);
  }
  return out;
}

Region svg_ellipse(Vec2 middle, Vec2 radii) {
  constexpr int kCorners = 40;
  Region out;
  Outline& outline = out.outlines.emplace_back();
  for (int i = 1; i <= kCorners; ++i) {
    const Vec2 d = corner(i, kCorners);
    outline.points.push_back(middle + radii * Vec2(d.y, d.x));
  }
  const bool round = radii.x == radii.y && radii.x > 0;
  if (round) out.arcs.push_back({middle, radii.x, 2 * M_PI / kCorners});
  outline.arc.assign(kCorners, round ? 0 : -1);
  return out;
}

}  // namespace burin::csg
