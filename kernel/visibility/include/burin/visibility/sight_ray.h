#pragma once
/// The ray along which the viewer sees a place of the sheet.

#include <burin/camera/camera.h>
#include <burin/visibility/occluder.h>

#include <algorithm>

namespace burin {

/// Begins before all that the occluder has: at the viewer, or, where there is no such place
/// (orthographic), far enough from the plane through the camera's centre and from what there is.
inline ViewRay sight_ray(const Camera& camera, Vec2 paper, const Occluder& occluder) {
  ViewRay ray = camera.ray(paper);
  if (camera.perspective()) return ray;
  const double before = glm::dot(ray.origin - occluder.center(), ray.direction);
  ray.origin -= std::max(2 * occluder.diagonal(), before + occluder.diagonal()) * ray.direction;
  return ray;
}

}  // namespace burin
