#pragma once
// What is seen of turned faces and of their axes; internal to the module.

#include <burin/camera/camera.h>
#include <burin/surface/surface.h>
#include <burin/visibility/occluder.h>

#include "turned_groups.h"

#include <memory>
#include <span>

namespace burin::detail {

class AxisSight {
 public:
  /// All of them must outlive it.
  AxisSight(std::span<const std::shared_ptr<const Surface>> surfaces, const Camera& camera,
            const Occluder& occluder)
      : surfaces_(surfaces), camera_(camera), occluder_(occluder) {}

  /// Whether the axis points to the viewer.
  bool seen_along(const TurnedGroup& group) const;
  /// Leaves the faces of which something is seen.
  void keep_seen(TurnedGroup& group) const;
  /// Whether nothing stands before a point of the axis but the solid that turns about it. `reach`:
  /// model mm beyond the solid's far end from which on the solid hides it, too.
  bool seen_at(const TurnedGroup& group, double height, double reach) const;

 private:
  bool free(Vec3 from) const;
  double lift(Vec3 at) const;
  bool wall_seen(const GroupFace& face) const;
  /// Whether the axis lies on the face of a section, where it passes a turned face.
  bool on_cut(const TurnedGroup& group, const GroupFace& face) const;
  /// The end of a face that is nearer to the viewer.
  bool rim_seen(const TurnedGroup& group, const GroupFace& face) const;
  template <class Place>
  bool enough_free(std::size_t count, const Place& place) const;
  const ProxyMesh& proxy_of(const GroupFace& face) const;

  std::span<const std::shared_ptr<const Surface>> surfaces_;
  const Camera& camera_;
  const Occluder& occluder_;
};

}  // namespace burin::detail
