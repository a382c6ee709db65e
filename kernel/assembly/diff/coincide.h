#pragma once
// Whether surfaces lie on each other, and by which move one comes to lie on the other; internal to
// the room.

#include <burin/base/placement.h>
#include <burin/base/run_context.h>
#include <burin/diff/match.h>
#include <burin/surface/surface.h>

#include "near_surface.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin::detail {

/// A part's triangles with what is asked of them again and again.
class Body {
 public:
  explicit Body(std::shared_ptr<const Surface> surface);

  const ProxyMesh& proxy() const { return surface_->proxy(); }
  const Pose& pose() const { return pose_; }
  /// Even by area, the same for the same triangles.
  const std::vector<Vec3>& samples() const { return samples_; }
  /// Whether a triangle lies within `reach` mm of a point.
  bool holds(Vec3 point, double reach) const { return near_.within(point, reach); }

 private:
  std::shared_ptr<const Surface> surface_;
  Pose pose_;
  std::vector<Vec3> samples_;
  NearSurface near_;
};

/// The share of the samples of both, each moved to the other, that lie on the other's surface
/// within `place` mm and what their triangles are off.
double share_on_each_other(const Body& before, const Body& after, const Placement& move,
                           double place);

/// Whether all of it does, but for a sample or two that rounding decides.
bool coincide(const Body& before, const Body& after, const Placement& move, double place);

/// The rigid move that turns least of those that lay a shape on its copy elsewhere; nothing where
/// none is found.
std::optional<Placement> rigid_move(const Body& before, const Body& after, double place,
                                    const RunContext& context);

/// The shift that lays most of a shape on a changed one, none where shifts gain less than 2 %; and
/// the share of both surfaces that then lies on the other's.
struct Shift {
  Vec3 by{0};
  double share = 1;
};
Shift best_shift(const Body& before, const Body& after, double place);

}  // namespace burin::detail
