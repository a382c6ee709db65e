#pragma once
// A surface of revolution over parameters; internal to the room.

#include <burin/contour_cut/sampler.h>

#include "revolution.h"

namespace burin::recognised {

/// Part of a patch over (u,v): the angle around the axis and the place along the profile; or, where
/// it lies across the axis, the distances from it along two directions (a cap: angles say nothing
/// at a pole).
class PatchChart {
 public:
  /// `cap`: 1 where the surface faces along the axis, -1 against it, 0 for angles. Nearer to the
  /// axis than `pole` mm, angles say nothing.
  PatchChart(const Patch& patch, int cap, double pole);

  /// Which chart suits a patch at a place.
  static int cap_at(const Patch& patch, Vec3 p);

  Vec2 parameters(Vec3 p) const;
  SurfaceSample sample(Vec2 uv) const;
  /// Lengths of the periods; 0 = none.
  Vec2 period() const;
  /// Whether all u are one point there.
  bool at_pole(Vec3 p) const;

 private:
  SurfaceSample around(Vec2 uv) const;
  SurfaceSample across(Vec2 uv) const;
  /// The profile at its parameter, and its derivative.
  Patch::Foot profile(double v, Vec2& derivative) const;
  /// The parameter of the profile at a distance from the axis, on the side of the cap.
  double at_radius(double r) const;
  bool circle() const { return patch_.profile == Patch::Profile::Circle; }

  const Patch& patch_;
  int cap_;
  double pole_;
  Vec3 e1_, e2_;
};

}  // namespace burin::recognised
