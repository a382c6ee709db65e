#pragma once
// Recognised triangles as charts that meet along edges; internal to the module.

#include <burin/forms/charted/atlas.h>

#include "faces.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace burin::recognised {

/// The charts of a refined mesh and its triangles over them. A chart is a patch (parted where its
/// caps begin) or the plane of a facet.
struct FacetAtlas {
  std::shared_ptr<const Atlas> atlas;
  ChartMesh mesh;
  /// For each chart its patch, or -1.
  std::vector<std::int32_t> patch;
  /// For each face of `mesh` the facet that it lies on, or began as.
  std::vector<std::int32_t> facet;
  /// Whether every triangle lies on a surface that is known: no stretch of facets is left whose
  /// surface is a guess.
  bool exact = true;
};

/// Corners have the normals of their wedges; nothing is cut yet.
FacetAtlas make_facet_atlas(const FacetMesh& mesh, const Faces& faces,
                            const std::shared_ptr<const Facets>& facets,
                            const std::shared_ptr<const Recognised>& round, double tolerance,
                            const RunContext& context);

}  // namespace burin::recognised
