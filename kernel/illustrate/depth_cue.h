#pragma once
// Lines that grow thin and pale with depth; internal to the module.

#include <burin/camera/camera.h>
#include <burin/illustrate/style.h>
#include <burin/mesh/proxy_mesh.h>

#include <span>
#include <vector>

namespace burin::detail {

/// What a style makes of depth: factors that go linearly from the nearest to the farthest point of
/// the scene, along the axis of the view. Keeps a copy of what it needs.
class DepthCue {
 public:
  DepthCue(std::span<const ProxyMesh* const> proxies, const Camera& camera, const Style& style);

  /// Whether widths change at all.
  bool active() const { return near_ != 1 || far_ != 1; }
  /// Factor of a line's width at a point.
  double width(const Vec3& p) const { return active() ? mix(p, near_, far_) : 1; }
  std::vector<double> widths(std::span<const Vec3> points) const;
  /// Share of its ink that a stroke's tone keeps at a point.
  double ink(const Vec3& p) const { return ink_ == 1 ? 1 : mix(p, 1, ink_); }
  bool pales() const { return ink_ != 1; }

 private:
  double mix(const Vec3& p, double at_near, double at_far) const;

  Camera camera_;
  double near_, far_, ink_;
  double front_ = 0, back_ = 0;
};

}  // namespace burin::detail
