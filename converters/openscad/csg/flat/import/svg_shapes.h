#pragma once
// Shapes of SVG as polygons, divided as OpenSCAD divides them; for converters/openscad alone.

#include <burin/base/vec.h>

#include "flat/transform.h"
#include "solid.h"

#include <string_view>
#include <vector>

namespace burin::csg {

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
std::vector<Outline> stroked(const std::vector<Vec2>& path, const SvgStroke& stroke);
/// 40 corners; equal radii are an arc.
Region svg_ellipse(Vec2 middle, Vec2 radii);
/// Outlines of path data, of any winding; parts that are open before the first closed one are
/// stroked, as OpenSCAD does. Throws InputError.
Region svg_path(std::string_view data, const SvgStroke& stroke);
/// What an attribute "transform" says; words that it does not know are left out.
Affine svg_transform(std::string_view text);

}  // namespace burin::csg
