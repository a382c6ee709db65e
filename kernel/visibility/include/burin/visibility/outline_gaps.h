#pragma once
/// What is missing of the outer outline.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/visibility/occluder.h>
#include <burin/visibility/visible_spans.h>

#include <span>
#include <vector>

namespace burin {

/// The outer outline is the border between object and paper and has no end. Where it ends without
/// another visible line within 0.25 mm of paper, the zero of the normals and the fold of the
/// triangles are not one line, as beside coarse facets. From such an end the border is followed by
/// rays, on a circle of 0.15 mm around one place to the next, until it meets a line that is seen:
/// what is returned, contours with points on the proxies, visible and outer all along. Borders that
/// meet none within 20 mm are left open, and so are ends beyond the sheet and those after the
/// first 500. `spans`: those of `features` in this view. Cost: some 40 rays a 0.15 mm that was
/// missing; nothing but a grid of the lines where nothing is. @cite Benard2019
std::vector<Curve3> outline_gaps(const Occluder& occluder,
                                 std::span<const ProxyMesh* const> proxies, const Camera& camera,
                                 std::span<const Curve3> features,
                                 std::span<const std::vector<Span>> spans,
                                 const RunContext& context);

}  // namespace burin
