#pragma once
// Into how many slices OpenSCAD divides an extrusion; for converters/openscad alone.

#include "solid.h"
#include "tree.h"

namespace burin::csg {

/// What an extrusion asks for; scale is at the top.
struct Extrusion {
  double height = 0, twist = 0;
  Vec2 scale{1};
  bool center = false;
};

/// One where the walls are flat or follow straight lines. A double: it may be beyond any memory.
double slices_of(const Node& node, const Extrusion& x, const Region& region);

}  // namespace burin::csg
