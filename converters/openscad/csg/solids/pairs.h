#pragma once
// Where the facets of several meshes meet; for csg/solids alone.

#include <burin/base/run_context.h>

#include "mesh.h"

#include <utility>

namespace burin::csg {

/// Both facets hold the points a and b and what is between them; a == b where they only touch.
struct Meeting {
  Id a = 0, b = 0, line = 0;
};

/// Where two facets of different planes meet, as closed sets.
void meet_facets(Space& space, const Facet& f, const Facet& g, std::vector<Meeting>& out);

struct FacetBox {
  std::uint32_t mesh = 0, facet = 0;
  Box3 box;
};
/// The pairs of boxes that overlap, but for those of one mesh that is not tangled.
std::vector<std::pair<std::uint32_t, std::uint32_t>> overlapping(std::span<const FacetBox> boxes,
                                                                 std::span<const char> tangled,
                                                                 RunContext& context);

}  // namespace burin::csg
