#pragma once
/// Flat parts of a surface, which get one direction each.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstdint>
#include <vector>

namespace burin::field {

/// A connected flat part: two unit arms of its constant cross; `first` belongs to family 1.
struct FlatPatch {
  Vec3 normal{0, 0, 1};
  Vec3 first{1, 0, 0};
  Vec3 second{0, 1, 0};
};

struct FlatPatches {
  std::vector<FlatPatch> patches;
  /// For each triangle its patch; -1 where the surface is curved (or the facet of something
  /// curved).
  std::vector<std::int32_t> face_patch;
};

/// Finds coplanar triangles and tells flat parts from the facets of curved ones: a flat part is
/// bounded by creases, or is much wider than the facets that it goes over into. Its cross follows
/// its outline (the mean of the outline's directions to the fourth power, by length); where the
/// outline has no such direction, as a circle, it follows `fallback`.
FlatPatches find_flat_patches(const ProxyMesh& proxy, Vec3 fallback, const RunContext& context);

}  // namespace burin::field
