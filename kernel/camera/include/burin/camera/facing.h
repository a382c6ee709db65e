#pragma once
/// Which way a surface faces in a view: the one function whose zeros are the contours, so that the
/// forms that cut their proxies along contours and the features that follow them agree.

#include <burin/camera/camera.h>

namespace burin {

/// Radians: a surface seen more edge-on than this counts as turned away, so that side walls and
/// caps that are meant to be seen exactly edge-on get one answer all over, not one that rounding
/// decides from triangle to triangle. Coordinates in single precision turn normals by up to some
/// 1e-5. It moves a contour by R * kEdgeOn^2 / 2 on paper (R: radius of curvature there): 1e-6 mm
/// at 200 mm.
inline constexpr double kEdgeOn = 1e-4;

/// g(p, n) = n . to_viewer - kEdgeOn: positive where a surface with unit normal n is turned to the
/// viewer. Perspective: the vector to the viewer is taken in units of the viewer's distance from
/// the picture's centre, not as a unit vector, which keeps the sign and makes g constant on a
/// plane.
class FacingFunction {
 public:
  explicit FacingFunction(const Camera& camera)
      : perspective_(camera.perspective()),
        direction_(camera.direction()),
        eye_(camera.eye()),
        unit_(perspective_ ? 1 / glm::length(camera.eye() - camera.center()) : 0) {}

  Vec3 to_viewer(const Vec3& p) const { return perspective_ ? (eye_ - p) * unit_ : direction_; }
  double operator()(const Vec3& p, const Vec3& unit_normal) const {
    return glm::dot(unit_normal, to_viewer(p)) - kEdgeOn;
  }

 private:
  bool perspective_;
  Vec3 direction_, eye_;
  double unit_;
};

}  // namespace burin
