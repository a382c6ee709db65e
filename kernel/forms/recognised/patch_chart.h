#pragma once
// A patch as a chart; internal to the module.

#include <burin/forms/charted/chart.h>

#include "revolution.h"

namespace burin::recognised {

/// Part of a patch over (u,v): those of its sheet; the angle around the axis and the place along
/// the profile; or, where it lies across the axis, the distances from it along two directions (a
/// cap: angles say nothing at a pole).
class PatchChart final : public Chart {
 public:
  /// `cap`: 1 where the surface faces along the axis, -1 against it, 0 for angles. Nearer to the
  /// axis than `pole` mm, angles say nothing.
  PatchChart(const Patch& patch, int cap, double pole);

  /// Which chart suits a patch at a place.
  static int cap_at(const Patch& patch, Vec3 p);

  const Patch& patch() const { return patch_; }
  /// Whether the outward normal is -(Su x Sv).
  bool reversed() const {
    if (patch_.sheet) return patch_.side < 0;
    return cap_ != 0 ? cap_ < 0 : circle() && patch_.radius < 0;
  }
  Vec2 parameters(Vec3 p) const;
  /// Whether all u are one point there.
  bool at_pole(Vec3 p) const;
  /// Makes the domain hold a place, and a little beside it; before anybody else knows of the chart.
  void extend_to(Vec2 uv);

  Vec3 position(Vec2 uv) const override { return derivatives(uv).p; }
  SurfaceDerivatives derivatives(Vec2 uv) const override;
  ParameterBox domain() const override;
  Vec2 period() const override;
  FaceKind kind() const override { return patch_.kind; }
  double largest_area() const override;

 private:
  /// The profile (r, h) at its parameter, with its derivatives.
  struct Profile {
    Vec2 p{0}, d{0}, dd{0};
  };
  Profile profile(double v) const;
  /// The parameter of the profile at a distance from the axis, on the side of the cap.
  double at_radius(double r) const;
  SurfaceDerivatives around(Vec2 uv) const;
  SurfaceDerivatives across(Vec2 uv) const;
  bool circle() const { return patch_.profile == Patch::Profile::Circle; }

  Patch patch_;
  int cap_;
  double pole_;
  Vec3 e1_, e2_;
  Vec2 low_{1e300}, high_{-1e300};
};

}  // namespace burin::recognised
