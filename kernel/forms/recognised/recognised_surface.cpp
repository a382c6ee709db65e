#include "recognised_surface.h"

#include <burin/surface/placed_frame.h>

namespace burin::recognised {

Frame RecognisedSurface::frame_of(const Patch& patch, Vec3 position) const {
  if (!place_.moves()) return patch.frame(position);
  Frame frame = placed(place_, patch.frame(back_.point(position)));
  frame.position = position;
  return frame;
}

Frame RecognisedSurface::frame(const SurfacePoint& point) const {
  const Patch* patch = patch_at(point.triangle);
  return patch ? frame_of(*patch, point.position) : mesh_->frame(point);
}

Vec3 RecognisedSurface::drawn_position(const SurfacePoint& point) const {
  const Patch* patch = patch_at(point.triangle);
  if (!patch) return mesh_->drawn_position(point);
  if (!place_.moves()) return patch->project(point.position);
  return place_.point(patch->project(back_.point(point.position)));
}

std::vector<Frame> RecognisedSurface::wedge_frames(const RunContext& context) const {
  std::vector<Frame> frames = mesh_->wedge_frames(context);
  const ProxyMesh& p = proxy();
  for (std::size_t t = 0; t < p.wedges.size(); ++t) {
    const Patch* patch = patch_at(static_cast<std::uint32_t>(t));
    if (!patch) continue;
    for (const std::uint32_t w : p.wedges[t]) {
      const Vec3 normal = frames[w].normal;
      frames[w] = frame_of(*patch, frames[w].position);
      // A wedge on a smooth edge has one normal for both sides.
      frames[w].normal = normal;
    }
  }
  return frames;
}

}  // namespace burin::recognised
