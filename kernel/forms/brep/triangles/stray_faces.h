#pragma once
/// Faces whose edges do not lie on them: what an exporter or a damaged file has torn apart.

#include <burin/forms/charted/raw_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

struct StrayFaces {
  /// For each face of the atlas nonzero where its edges lie too far beside its surface; empty where
  /// there is none.
  std::vector<std::uint8_t> marked;
  /// The farthest node of these, in units of the part.
  double distance = 0;

  void add(const StrayFaces& others);
};

/// `size`: the diagonal of the part. Vertices on edges stand where the edge is in space, or where
/// it is on the neighbour; on a surface far from there neither refinement nor contours come to an
/// end. Cost: one evaluation a corner, in parallel.
StrayFaces find_stray_faces(const RawMesh& raw, const Atlas& atlas, double size,
                            const RunContext& context);

}  // namespace burin
