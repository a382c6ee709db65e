#pragma once
// What both extrusions share; for converters/openscad alone.

#include "cap.h"
#include "flat.h"

#include <cstdint>
#include <vector>

namespace burin::csg {

/// More triangles than any machine that draws holds.
inline constexpr double kMostSwept = 2e7;
/// mm: OpenSCAD's finest grid, within which points are one.
inline constexpr double kFinest = 0x1p-20;

Solid linear_extruded(Evaluation& e, std::uint32_t node, const Region& region);
Solid rotate_extruded(Evaluation& e, std::uint32_t node, const Region& region);

/// Throws InputError where so many triangles would be too many.
void check_swept(double triangles, const char* what);
/// Rows for smooth pieces; returns the number of the first.
std::int32_t add_grids(std::vector<Turned>& surfaces, std::vector<PointGrid> pieces);
/// Positions that no triangle uses go.
void drop_unused(Solid& solid);

}  // namespace burin::csg
