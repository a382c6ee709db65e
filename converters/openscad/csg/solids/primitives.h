#pragma once
// The solids that a tree begins with, and what a matrix makes of them; for csg/solids alone.

#include "../flat/flat.h"

#include <optional>

namespace burin::csg {

/// cube, sphere, cylinder, polyhedron: tessellated as OpenSCAD does, empty where it makes nothing
/// of them. Throws InputError for a circle of too many corners.
Solid primitive(Evaluation& e, std::uint32_t at);

/// Under a matrix; nothing where it keeps circles from being circles about one axis.
std::optional<Turned> moved(const Turned& turned, const Matrix& m);
Solid moved(const Solid& solid, const Matrix& m);

}  // namespace burin::csg
