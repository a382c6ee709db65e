#pragma once
// Curves in which parts pass through each other.

#include <burin/base/curve.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/feature/feature.h>
#include <burin/mesh/proxy_mesh.h>

#include "exact/triangle_pairs.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// A connected component of a part and the triangles of it that may meet another one.
struct PieceOfPart {
  std::int32_t part = -1;
  const ProxyMesh* proxy = nullptr;
  bool transparent = false;
  /// How much its lines show.
  double ink = 0;
};

/// The intersection curves of all components, of different parts or of one. They run in the concave
/// edge of the union: on closed surfaces they are self-hidden where either surface is turned away.
/// A transparent part hides none of another one: those of a solid and a transparent part are the
/// solid one's, and self-hidden where that is turned away; those of two transparent parts are there
/// twice, for each as it shows them.
std::vector<Curve3> intersection_curves(std::span<const ProxyMesh* const> proxies,
                                        const Camera& camera, const MeetingParts& meeting,
                                        Diagnostics& diagnostics, const RunContext& context);

/// Chains the segments of two components, drops contacts, and cuts where the smooth region of `a`
/// changes.
std::vector<Curve3> chain_intersections(std::span<const PairSegment> segments, const PieceOfPart& a,
                                        const PieceOfPart& b, const Camera& camera);

}  // namespace burin
