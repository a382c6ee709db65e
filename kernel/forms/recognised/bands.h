#pragma once
// Runs of facets around an axis; internal to the module.

#include "facets.h"
#include "revolution.h"

#include <cstdint>
#include <vector>

namespace burin::recognised {

/// Facets that are tangent to one cone or cylinder at equal angles. Its patch is a Line.
struct Band {
  Patch patch;
  /// A direction from the axis to the middle of a facet.
  Vec3 phase{1, 0, 0};
  std::vector<std::int32_t> facets;
};

struct Bands {
  std::vector<Band> list;
  /// For each facet its band, or -1.
  std::vector<std::int32_t> of;
  /// Spheres, walls of outlines (and tori that are known, not recognised), and for each facet its
  /// own, or -1.
  std::vector<Patch> spheres;
  std::vector<std::int32_t> of_sphere;
};

/// Walls of outlines first, as stretches of theirs look like cylinders; spheres before runs, as the
/// meridians of a sphere look like runs; larger runs first; a facet is
/// in one at the most. Bands of the same surface are one.
Bands find_bands(const TriMesh& mesh, const Facets& facets, const RunContext& context);

}  // namespace burin::recognised
