#pragma once
// A piece of a surface of revolution in closed form, or of a smooth surface through points;
// internal to the module.

#include <burin/surface/surface.h>

#include "sheet.h"

#include <cstdint>
#include <memory>

namespace burin::recognised {

/// An axis and a place on it. Points in the plane of a profile are (r, h): the distance from the
/// axis and the height along it.
struct Axis {
  Vec3 origin{0}, direction{0, 0, 1};

  Vec2 profile(Vec3 p) const {
    const double h = glm::dot(p - origin, direction);
    return {glm::length(p - origin - h * direction), h};
  }
  /// The unit vector away from the axis at a point; any at the axis itself.
  Vec3 outward(Vec3 p) const;
};

/// What stands for a run of facets around an axis. The profile is a line (normal . (r,h) = offset),
/// a circle, or a cubic over a line; of a `Sheet` it has none, and no axis.
struct Patch {
  enum class Profile : std::uint8_t { Line, Circle, Cubic, Sheet };

  Axis axis;
  /// Angle from facet to facet around the axis, and the largest distance in mm between facets and
  /// surface.
  double step = 0, sagitta = 0;
  /// The largest angle between neighbouring facets of the run, in space.
  double turn = 0;
  Profile profile = Profile::Line;
  /// Unit, away from the material.
  Vec2 normal{1, 0};
  double offset = 0;
  /// Circle: its middle; the sign of `radius` is that of the outward normal.
  Vec2 middle{0};
  double radius = 0;
  /// Cubic: where it starts on the line, the length of the chord along (-normal.y, normal.x), and
  /// the slopes at both ends.
  Vec2 start{0};
  double length = 1, slope0 = 0, slope1 = 0;
  /// Sheet: the surface, which of its cells, and 1 where Su x Sv is outward, else -1.
  std::shared_ptr<const Sheet> sheet;
  GridWindow window;
  double side = 1;
  FaceKind kind = FaceKind::Freeform;
  /// Patches of one chain go over into one another smoothly.
  std::int32_t chain = -1;

  struct Foot {
    Vec2 point{0}, normal{1, 0};
    /// Of the profile, positive where it bends away from the outward normal.
    double curvature = 0;
  };
  Foot foot(Vec2 rh) const;
  Vec2 along() const { return {-normal.y, normal.x}; }

  /// The nearest point of the surface, to first order.
  Vec3 project(Vec3 p) const;
  /// Where an edge with both ends on a surface that is no sheet is put halfway. On cones, and on
  /// rims, it is at half the height of the ends: the nearest point would slide along the surface,
  /// by more than narrow strips are high, while the rims beside it stay. Else the nearest point.
  Vec3 halfway(Vec3 a, Vec3 b) const;
  /// From the surface to a point, positive outside, to first order; and the normal there.
  double distance(Vec3 p, Vec3& normal_there) const;
  Vec3 normal_at(Vec3 p) const;
  Frame frame(Vec3 p) const;
  /// Of a sheet.
  Vec3 outward(const SurfaceDerivatives& d) const;

 private:
  SurfaceDerivatives nearest(Vec3 p) const { return sheet->derivatives(sheet->locate(p, window)); }
};

/// Some cells of a smooth surface through points.
Patch patch_on(std::shared_ptr<const Sheet> sheet, const GridWindow& window);

}  // namespace burin::recognised
