#pragma once
// Closed surfaces of plane facets over the points of a Space; for csg/solids alone.

#include <burin/base/box.h>

#include "../solid.h"
#include "space.h"

#include <span>

namespace burin::csg {

/// From a to b, the facet's material to the left seen from outside.
struct Edge {
  Id a = 0, b = 0, line = 0;
};

/// Part of a plane: one polygon or several, holes too.
struct Facet {
  Id plane = 0;
  /// Outside is where the plane's normal points.
  bool along = true;
  /// What the facet stands for, of the surfaces of the whole evaluation, or -1.
  std::int32_t surface = -1;
  std::vector<Edge> edges;
  Box3 box;
};

struct Mesh {
  std::vector<Facet> facets;
  Box3 box;
  /// It may cut itself, as files and polyhedron() may: inside is then what an odd number of facets
  /// separates from afar.
  bool tangled = false;
};

/// The facets of a solid under a matrix: triangles in one plane become one facet. `surfaces` says
/// what number each row of the solid's surfaces has, or -1. Empty where the matrix flattens it.
Mesh mesh_of(Space& space, const Solid& solid, Id matrix, bool mirrored,
             std::span<const std::int32_t> surfaces, bool tangled);
void find_boxes(const Space& space, Mesh& mesh);

}  // namespace burin::csg
