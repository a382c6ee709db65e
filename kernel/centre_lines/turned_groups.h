#pragma once
// Turned faces about one axis; internal to the module.

#include <burin/base/run_context.h>
#include <burin/surface/surface.h>
#include <burin/surface/turned_faces.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace burin::detail {

/// A face with its extent about the axis of its group.
struct GroupFace {
  std::int32_t part = -1;
  TurnedFace turned;
  TurnedExtent extent;
};

/// Faces of one part, or of several, that turn about one axis.
struct TurnedGroup {
  Axis axis;
  /// A ball by itself, which has no axis.
  bool sphere = false;
  /// Whether a section runs along the axis.
  bool cut_along = false;
  /// By part and face.
  std::vector<GroupFace> faces;

  /// The first of the largest radius.
  const GroupFace& largest() const;
  double radius() const { return largest().extent.radius; }
  /// A point of the axis, model mm from its point.
  Vec3 at(double height) const { return axis.point + height * axis.along; }
  /// On the axis, in the middle of the first face.
  Vec3 middle() const;
};

/// The groups of a part, by their first face: those that go far enough round. `near`: model mm
/// within which axes are one.
std::vector<TurnedGroup> turned_groups(const Surface& surface, std::int32_t part, double near,
                                       const RunContext& context);

/// Groups of several parts about one axis become one.
std::vector<TurnedGroup> joined(std::vector<TurnedGroup> groups, double near);

}  // namespace burin::detail
