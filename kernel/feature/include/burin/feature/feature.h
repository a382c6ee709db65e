#pragma once
/// Feature lines of a view: contours, creases, boundaries, intersections of parts.

#include <burin/base/curve.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>

#include <span>
#include <vector>

namespace burin {

struct FeatureOptions {
  bool contours = true;
  bool creases = true;
  bool boundaries = true;
  /// Curves in which different parts (or closed components of one part) pass through each other.
  bool intersections = true;
};

/// All feature lines of one proxy a part, hidden ones too, chained into long paths; a chain ends
/// where its kind, part or smooth region changes and at vertices where more than two lines of its
/// kind meet.
///
/// Contours of smooth regions are the zero set of g = normal . to_viewer, linear in each triangle
/// over its wedge normals (perspective too); a crease between a triangle turned to the viewer and
/// one turned away is a contour as well. `source.face` is the smooth region (of creases: that of
/// the front face), `source.edge` the index of the crease or boundary chain inside its part, the
/// same for every view. @cite Hertzmann2000, Benard2019
std::vector<Curve3> extract_features(std::span<const ProxyMesh* const> proxies,
                                     const Camera& camera, const FeatureOptions& options,
                                     Diagnostics& diagnostics, const RunContext& context);

}  // namespace burin
