#pragma once
/// Centre lines of turned faces, and centre marks where these are seen along their axis.

#include <burin/base/curve.h>
#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/surface/surface.h>
#include <burin/visibility/occluder.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

struct CentreLineOptions {
  /// One a part: paper mm from its outline to the end of a line; absent: it has no lines.
  std::vector<std::optional<double>> over;
  /// Whether they are drawn of faces, too, of which nothing is seen.
  bool hidden = false;
};

/// Lines of kind Centre in the order of parts, each visible all along. Faces about one axis share a
/// line, in several parts, too; it has the part and the face of the largest. A face has one where
/// together with those about its axis it goes more than half of the way round (rounded corners do
/// not), half of that where a section runs along the axis. Seen along its axis a face has two lines
/// that cross, as long as the largest face that is seen there; three and more equal holes of a part
/// on one circle have that circle and one line each. Faces narrower than 1.2 mm on paper have none;
/// a diagnostic counts them. Throws Cancelled. Cost: that of `turned_faces`, and at most 170 rays a
/// face.
/// @cite ISO128part2
std::vector<Curve3> centre_lines(std::span<const std::shared_ptr<const Surface>> surfaces,
                                 const Camera& camera, const Occluder& occluder,
                                 const CentreLineOptions& options, Diagnostics& diagnostics,
                                 const RunContext& context);

}  // namespace burin
