#pragma once
// The cylinders of a surface, and which of their ends are open; internal to the module.

#include <burin/base/run_context.h>
#include <burin/surface/surface.h>
#include <burin/surface/turned_faces.h>

#include "own_rays.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace burin::detail {

/// One face, or several that are one cylinder.
struct Cylinder {
  Axis axis;
  /// `extent.radius` is that of all of it.
  TurnedExtent extent;
  bool hollow = false;
  std::vector<std::int32_t> faces;

  Vec3 at(double height) const { return axis.point + height * axis.along; }
};

/// Those that go more than half the way round, by the number of their first face.
std::vector<Cylinder> cylinders_of(const Surface& surface, const RunContext& context);

/// Where a thread on a cylinder ends if it goes as far as it can: at a chamfer or a countersink
/// beyond the cylinder, where this has the radius of the thin lines. Nothing where the end is not
/// open: at a shoulder, at the ground of a hole.
std::optional<double> open_end(const Cylinder& cylinder, double thin, bool high,
                               const Surface& surface, const OwnRays& rays);

}  // namespace burin::detail
