#pragma once
// Triangles that stand across the surface that they are to lie on; internal to the module.

#include "meet.h"
#include "refine.h"

namespace burin::recognised {

/// Turns edges within one round surface where a triangle beside them stands across it: where facets
/// meet in edges that are not those of the surfaces, three corners of one facet may lie on one rim.
/// On the surface such a triangle has no area, and its inner edge would run along the rim.
void turn_standing(FacetMesh& mesh, const Meeting& meet, const RunContext& context);

}  // namespace burin::recognised
