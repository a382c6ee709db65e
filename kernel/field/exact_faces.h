#pragma once
/// What an exact form tells of its faces, which of a mesh has to be guessed.

#include <burin/base/run_context.h>
#include <burin/field/field.h>
#include <burin/surface/surface.h>

#include "flat_patches.h"

#include <optional>
#include <vector>

namespace burin::field {

/// The curved faces of which everybody knows how lines run.
inline bool is_ruled(FaceKind kind) {
  return kind == FaceKind::Cylinder || kind == FaceKind::Cone || kind == FaceKind::Torus;
}

/// Whether d1 and d2 are the circles and rulings, or the circles, of a face of that kind.
inline bool has_exact_lines(const Frame& frame) { return !frame.umbilic && is_ruled(frame.kind); }

/// For each triangle the kind of its face of the input, Plane and Sphere also for faces of other
/// equations that have that shape; empty where the proxy knows no faces.
std::vector<FaceKind> find_face_kinds(const Surface& surface, const RunContext& context);

/// For each smooth region whose curved faces are spheres alone, a ball, the unit axis that its
/// circles of latitude go round: what the policy says; under FacePolicy::Sphere::Axis the axis of
/// the ball's own border where that has one (the rim of a dome). Nothing for other regions.
using BallAxes = std::vector<std::optional<Vec3>>;
BallAxes find_balls(const ProxyMesh& proxy, const std::vector<FaceKind>& kinds,
                    const SmoothedOptions& options);

/// What the curved faces that meet at a wedge say of it.
struct CurvedFrames {
  /// For each wedge the most confident of their frames; umbilic where only flat faces meet. A wedge
  /// on the border of a plane and a fillet has two frames: the fillet's counts.
  std::vector<Frame> best;
  /// A face that says something else than `best` at a wedge of its border.
  struct Other {
    std::uint32_t wedge = 0;
    Frame frame;
    /// A third of the area of the face's triangles at the wedge, in model mm^2.
    double area = 0;
  };
  std::vector<Other> others;  // by wedge
};
CurvedFrames curved_frames(const Surface& surface, const FlatPatches& flats,
                           const RunContext& context);

}  // namespace burin::field
