#pragma once
/// Feature lines of a view: contours, creases, boundaries, intersections of parts.

#include <burin/base/curve.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/feature/options.h>
#include <burin/mesh/proxy_mesh.h>

#include <span>
#include <vector>

namespace burin {

/// What lines along which parts meet need to know of these; one value a part each, or none at all.
struct MeetingParts {
  /// Whether it is looked through.
  std::vector<bool> transparent{};
  /// How much its own lines show. Of two parts their intersection belongs to the one whose lines
  /// show more, of equal ones to the first.
  std::vector<double> ink{};

  bool operator==(const MeetingParts&) const = default;
};

/// All feature lines of one proxy per part, hidden ones too, chained into long paths; a chain ends
/// where its kind, its source, or which of its sides face the viewer changes, and at vertices where
/// more than two lines of its kind meet. Ends that meet do so bit for bit.
///
/// Contours of smooth regions are the zero set of g = normal . to_viewer, linear in each triangle
/// over its wedge normals (perspective too); a crease between a side turned to the viewer and one
/// turned away is a contour as well, and is kept where either contours or creases are asked for.
/// What is seen edge-on counts as turned away. `source.face` is the smooth region (of creases: that
/// of the front side), `source.edge` the index of the crease or boundary chain inside its part, the
/// same for every view; -1 for contours inside regions and for intersections. Intersections belong
/// to one of both parts (`MeetingParts::ink`), have crease_sign -1 and are not `occluding`. Of a
/// solid part and a transparent one they belong to the solid one, and are `self_hidden` where that
/// is turned away, whichever way the other is. Those of two transparent parts are found twice, for
/// each as it shows them alone, first for the one that they belong to.
///
/// Proxies that know their source: `source.edge` is the edge of the input, one per curve, and
/// `source.face` the face of the input. A contour runs on over all faces of a smooth region;
/// `source.face` is then the one that holds most of its length on paper (see source_faces.h for the
/// others). Smooth edges and seams are of kind Smooth and Seam, not `occluding`, and are left out
/// where a contour runs along them.
///
/// `self_hidden` is set on closed components alone: creases and smooth edges with both sides
/// turned away, folds in a hollow, contours whose far side is in front, intersections with either
/// surface turned away that hides. Per point `normals`, per segment `faces` and `self_hidden` are
/// always present.
///
/// Left out, by limits in paper mm: closed contours that are noise (diagnostic
/// "feature.noise_loops"), short weak creases that separate nothing, intersections where parts
/// merely touch. Results do not depend on the number of threads. Throws Cancelled. Cost: 0.03 s per
/// million triangles, 0.1 s more where two parts of half a million each pass through each other.
/// @cite Hertzmann2000, Benard2019, Edelsbrunner1990
std::vector<Curve3> extract_features(std::span<const ProxyMesh* const> proxies,
                                     const Camera& camera, const FeatureOptions& options,
                                     Diagnostics& diagnostics, const RunContext& context,
                                     const MeetingParts& meeting = {});

}  // namespace burin
