#pragma once
/// What a smoothed field is asked to follow: curvature, creases, and the style's direction where
/// there is neither.

#include <burin/base/run_context.h>
#include <burin/field/field.h>

#include "exact_faces.h"
#include "flat_patches.h"
#include "hierarchy.h"
#include "wedge_graph.h"

#include <cstdint>
#include <vector>

namespace burin::field {

/// One entry a wedge, in its TangentBasis; zero for wedges without curved triangles.
struct Constraints {
  /// The cross that is wanted (a direction to the fourth power) times how much, and how much.
  std::vector<Vec2> pull;
  std::vector<double> mass;
  /// The line that family 1 should follow (a direction to the second power) times how much, and how
  /// much.
  std::vector<Vec2> line_pull;
  std::vector<double> line_mass;
  /// Nonzero where the directions of an exact face are followed whatever the crosses say.
  std::vector<std::uint8_t> certain;
};

/// `exact`: as the surface says of its frames.
Constraints find_constraints(const ProxyMesh& proxy, const CurvedFrames& frames, bool exact,
                             const FlatPatches& flats, const WedgeGraph& graph,
                             const Hierarchy<Vec2>& hierarchy, const SmoothedOptions& options,
                             const RunContext& context);

}  // namespace burin::field
