#pragma once
// What of many meshes cannot be seen in what a formula makes of them; for csg/solids alone.

#include <burin/base/run_context.h>

#include "boolean.h"

namespace burin::csg {

/// What lies within a convex mesh (or where all of another mesh can be seen from), and what is
/// solid or cut away there whatever else is: in a union with it, or in what it is cut from.
struct Culled {
  /// By mesh: it lies in another one of its union, and is as good as none.
  std::vector<char> gone;
  /// By mesh and facet: what lies on its sides does not depend on its mesh.
  std::vector<std::vector<char>> hidden;
};

/// Leaving these out changes nothing: all is decided exactly. The work is bounded by a multiple of
/// the number of facets; what is not looked at stays.
Culled cull(Space& space, std::span<const Mesh> meshes, const Formula& formula,
            RunContext& context);

}  // namespace burin::csg
