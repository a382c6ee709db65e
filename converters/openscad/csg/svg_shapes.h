#pragma once
// Shapes of SVG as polygons, divided as OpenSCAD divides them; for converters/openscad alone.

#include <burin/base/vec.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace burin::csg {

using SvgPath = std::vector<Vec2>;

/// How open lines are drawn. Widths in user units.
struct SvgStroke {
  double width = 1;
  enum class Cap { Butt, Round, Square } cap = Cap::Square;
  enum class Join { Miter, Round, Bevel } join = Join::Miter;
};

/// A number that is all of the text, else 0: lengths with units are 0, as OpenSCAD has it.
double svg_number(std::string_view text);
/// Numbers between blanks and commas.
std::vector<double> svg_numbers(std::string_view text);
/// The outline of a stroke along `path`. Throws InputError where coordinates are beyond reason.
std::vector<SvgPath> stroked(const SvgPath& path, const SvgStroke& stroke);
SvgPath svg_ellipse(Vec2 middle, Vec2 radii);
/// Outlines of path data; parts that are open before the first closed one are stroked, as OpenSCAD
/// does. Throws InputError.
std::vector<SvgPath> svg_path(std::string_view data, const SvgStroke& stroke);

/// Columns a b, c d, e f of SVG's matrices.
struct SvgMatrix {
  std::array<double, 6> m{1, 0, 0, 1, 0, 0};
  Vec2 operator()(Vec2 p) const {
    return {m[0] * p.x + m[2] * p.y + m[4], m[1] * p.x + m[3] * p.y + m[5]};
  }
  SvgMatrix operator*(const SvgMatrix& inner) const;
};
/// What an attribute "transform" says; words that it does not know are left out.
SvgMatrix svg_transform(std::string_view text);

}  // namespace burin::csg
