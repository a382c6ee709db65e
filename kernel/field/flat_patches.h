#pragma once
/// Flat parts of a surface, which get one direction each.

#include <burin/base/run_context.h>
#include <burin/surface/surface.h>

#include "flat_cross.h"

#include <cstdint>
#include <vector>

namespace burin::field {

/// Confidence from which principal directions are followed at a smooth border.
constexpr double kSure = 0.5;

struct FlatPatches {
  std::vector<FlatPatch> patches;
  /// For each triangle its patch; -1 where the surface is curved (or the facet of something
  /// curved).
  std::vector<std::int32_t> face_patch;
};

/// Finds coplanar triangles and tells flat parts from the facets of curved ones: a flat part is
/// bounded by creases, or is much wider than the facets that it goes over into. Their directions
/// are those of `flat_cross`.
FlatPatches find_flat_patches(const ProxyMesh& proxy, const std::vector<Frame>& frames,
                              Vec3 fallback, const RunContext& context);

}  // namespace burin::field
