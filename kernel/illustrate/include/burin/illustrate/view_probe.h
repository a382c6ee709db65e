#pragma once
/// What is seen through a point of the sheet, for whoever places strokes.

#include <burin/camera/camera.h>
#include <burin/stroke/stroke.h>
#include <burin/visibility/occluder.h>

#include <vector>

namespace burin {

/// Says what the viewer sees; strokes are placed on the parts that are flagged, one flag a part;
/// none = all. Occluder and camera must outlive it.
ViewProbe view_probe(const Occluder& occluder, const Camera& camera, std::vector<bool> parts = {});

}  // namespace burin
