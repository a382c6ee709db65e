#pragma once
/// Triangles cut along the exact contours of a view.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/contour_cut/sampler.h>
#include <burin/work_mesh/chart_mesh.h>

namespace burin {

struct ContourCutOptions {
  /// Paper mm between the chords of a contour and the contour.
  double chord = 0.005;
  /// Paper mm to a vertex within which a contour passes through the vertex.
  double snap = 0.001;
};

/// Refines the triangles that contours pass through until the chords of the contours are within
/// `chord` paper mm of the exact contour n(u,v) . to_viewer = kEdgeOn, then cuts the triangles
/// along them: afterwards no triangle has corners with g of both signs, contours are chains of
/// edges between a front and a back side, and `on_contour` marks their corners (those without a
/// normal, too). New vertices lie on the surface, those on model edges on the edge, shared by both
/// faces; both sides of a smooth edge see one g. Zeros are found by a bracketed method on the edges
/// of the triangles, so that they never fail; contours nearer than `snap` paper mm to a vertex pass
/// through it. Closed contours inside one triangle are found where they are farther than `chord`
/// from it. Returns false where that was ended at three times the triangles and 100,000 more.
/// Deterministic. Cost: about 1 us per triangle that is looked at, 20 us per triangle that is cut.
/// @cite Benard2019
bool cut_along_contours(ChartMesh& mesh, const Sampler& surface, const Camera& camera,
                        const ContourCutOptions& options, const RunContext& context);

/// Says that it was ended: surface.contours_bounded.
void add_contours_bounded(Diagnostics& diagnostics);

}  // namespace burin
