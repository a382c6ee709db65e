#pragma once
/// The hatching of cut areas.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>

#include <span>
#include <vector>

namespace burin {

/// Straight parallel lines over the triangles that close cuts (`ProxyMesh::cut_plane`), of kind
/// Pattern, one part beside the other. By the rules of technical drawings: 45 degrees to the
/// horizontal of the plane, for parts whose cut areas are neighbours (within 1 mm on paper) 135,
/// 30, 120, 60, 150, skipping an angle within 15 degrees of which more than half of the area's
/// outline runs; the distance is 0.12 times the square root of the area on paper, 0.7 to 3.5 mm.
/// All areas of a part in one plane share a lattice that is fixed in the model, so that two views
/// agree. `magnified`: how many times as large as another view of the same parts this one is, a
/// detail: it has the angles of that view and its lines, and others half-way between them where
/// they are more than 3.5 mm apart. `ranks`, one a part or none: where areas of two parts overlap
/// that of the higher rank is hatched, of equal ones that of the first part. Cost: the triangles
/// times the lines over each. @cite ISO128
std::vector<Curve3> hatch_cuts(std::span<const ProxyMesh* const> proxies, const Camera& camera,
                               const RunContext& context, double magnified = 1,
                               std::span<const double> ranks = {});

}  // namespace burin
