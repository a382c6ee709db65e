#pragma once
// Facets whose surface is known; internal to the module.

#include <burin/forms/recognised/turned_surface.h>

#include "bands.h"
#include "facets.h"

namespace burin::recognised {

struct KnownFacets {
  Facets facets;
  Bands bands;
};

/// In place of `find_facets` and `find_bands`: those judge facets alone of which nothing is known.
/// Facets of surfaces that are one
/// within the noise of the mesh are one band; a surface whose triangles face both ways is two.
/// Throws std::invalid_argument where `known` has not one row a triangle.
KnownFacets known_facets(const TriMesh& mesh, const Topology& topology, const KnownSurfaces& known,
                         const RunContext& context);

}  // namespace burin::recognised
