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

SvgMatrix multiplied(const SvgMatrix& a, const SvgMatrix& b) {
  const auto& m = a.m;
  const auto& n = b.m;
  return {{m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1], m[0] * n[2] + m[2] * n[3],
           m[1] * n[2] + m[3] * n[3], m[0] * n[4] + m[2] * n[5] + m[4],
           m[1] * n[4] + m[3] * n[5] + m[5]}};
}

/// One word of a transform; those with a wrong count of numbers do nothing.
SvgMatrix one_transform(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return {{v[0], v[1], v[2], v[3], v[4], v[5]}};
  if (name == "translate" && (n == 1 || n == 2)) return {{1, 0, 0, 1, v[0], n > 1 ? v[1] : 0}};
  if (name == "scale" && (n == 1 || n == 2)) return {{v[0], 0, 0, n > 1 ? v[1] : v[0], 0, 0}};
  if (name == "rotate" && (n == 1 || n == 3)) {
    const Vec2 d = direction(v[0]);
    const SvgMatrix turn{{d.x, d.y, -d.y, d.x, 0, 0}};
    if (n == 1) return turn;
    return SvgMatrix{{1, 0, 0, 1, v[1], v[2]}} * turn * SvgMatrix{{1, 0, 0, 1, -v[1], -v[2]}};
  }
  const double slope = n == 1 ? std::tan(v[0] * M_PI / 180) : 0;
  if (name == "skewX") return {{1, 0, slope, 1, 0, 0}};
  if (name == "skewY") return {{1, slope, 0, 1, 0, 0}};
  return {};
}

}  // namespace

SvgMatrix SvgMatrix::operator*(const SvgMatrix& inner) const { return multiplied(*this, inner); }

SvgMatrix svg_transform(std::string_view text) {
  SvgMatrix out;
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

std::vector<SvgPath> stroked(const SvgPath& path, const SvgStroke& stroke) {
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
  std::vector<SvgPath> out;
  for (const ClipperLib::Path& p : result) {
    SvgPath& outline = out.emplace_back();
    for (const ClipperLib::IntPoint& q : p) {
      outline.emplace_back(static_cast<double>(q.X) / kUnits, static_cast<double>(q.Y) / kUnits);
    }
  }
  return out;
}

SvgPath svg_ellipse(Vec2 middle, Vec2 radii) {
  constexpr int kCorners = 40;
  SvgPath out;
  for (int i = 1; i <= kCorners; ++i) {
    const Vec2 d = corner(i, kCorners);
    out.push_back(middle + radii * Vec2(d.y, d.x));
  }
  return out;
}

}  // namespace burin::csg
