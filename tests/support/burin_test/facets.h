#pragma once
/// A mesh as a surface of its own facets.

#include <burin/forms/mesh/mesh_form.h>

#include <limits>
#include <memory>
#include <utility>

namespace burin::test {

/// None of them is divided, however coarse.
inline std::shared_ptr<const Surface> realised(TriMesh mesh, bool curvature = true) {
  RunContext context;
  return MeshForm(std::move(mesh))
      .realise({.tolerance = std::numeric_limits<double>::infinity(), .curvature = curvature},
               context);
}

}  // namespace burin::test
