#pragma once
/// What an exact form tells of its faces, which of a mesh has to be guessed.

#include <burin/base/run_context.h>
#include <burin/field/field.h>
#include <burin/surface/surface.h>

#include "flat_patches.h"

#include <vector>

namespace burin::field {

/// Whether d1 and d2 are the circles and rulings, or the circles, of a face of that kind.
inline bool has_exact_lines(const Frame& frame) {
  return !frame.umbilic && (frame.kind == FaceKind::Cylinder || frame.kind == FaceKind::Cone ||
                            frame.kind == FaceKind::Torus);
}

/// For each triangle the kind of its face of the input (Plane also for flat faces of other kinds);
/// empty where the proxy knows no faces.
std::vector<FaceKind> find_face_kinds(const Surface& surface, const RunContext& context);

/// For each smooth region nonzero where its curved faces are spheres alone: balls, whose directions
/// nothing but the style decides.
std::vector<std::uint8_t> find_balls(const ProxyMesh& proxy, const std::vector<FaceKind>& kinds);

/// The axis that circles of latitude go round on a ball.
inline Vec3 ball_axis(const SmoothedOptions& options) {
  const bool view = options.policy.sphere == FacePolicy::Sphere::View;
  return normalize_or(view ? options.view : options.fallback, Vec3(0, 0, 1));
}

/// For each wedge the most confident of the frames of the curved faces that meet there; umbilic
/// where only flat faces do. A wedge on the border of a plane and a fillet has two frames: the
/// fillet's counts.
std::vector<Frame> curved_frames(const Surface& surface, const FlatPatches& flats,
                                 const RunContext& context);

}  // namespace burin::field
