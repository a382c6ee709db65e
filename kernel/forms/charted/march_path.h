#pragma once
// Geodesics of one chart as paths in (u,v).

#include <burin/forms/charted/atlas.h>

#include "break_lines.h"

namespace burin::detail {

/// A place of a geodesic run through with unit speed: (u,v), its derivative by arc length (the
/// components alpha, beta of the unit tangent), S there, and the second derivative of (u,v).
struct PathState {
  Vec2 uv{0}, velocity{0}, acceleration{0};
  SurfaceDerivatives s;

  Vec3 direction() const { return velocity.x * s.u + velocity.y * s.v; }
};

/// What one step leaves open: model mm of position and radians of direction.
struct PathError {
  double position = 0, direction = 0;
};

/// Geodesics on one face, within a cell of it: derivatives beyond its sides are those at them.
class GeodesicPath {
 public:
  GeodesicPath(const PlacedAtlas& atlas, std::int32_t face, const ParameterBox& cell = kUnbounded)
      : atlas_(atlas), face_(face), cell_(cell) {}

  /// The state at `uv` in the direction of `tangent` (projected); false where there is none: the
  /// tangent vanishes, or the surface has no tangent plane.
  bool start(Vec2 uv, Vec3 tangent, PathState& state) const;
  Vec3 normal(const PathState& state) const { return atlas_.normal(face_, state.uv, state.s); }
  /// The state `length` further, by the classical method of the fourth order; the error is that of
  /// the embedded one of the third order, which uses the slope at the end: the next step needs it
  /// anyway. False where the path is not defined. @cite Hairer1993
  bool step(const PathState& from, double length, PathState& to, PathError& error) const;
  /// The same for a step so short that a prediction by the acceleration and one correction are
  /// within `distance` model mm: one evaluation of S instead of four. False where they may not be.
  /// The acceleration of `to` is that of the prediction: no further step should begin there.
  bool short_step(const PathState& from, double length, double distance, PathState& to) const;

 private:
  SurfaceDerivatives derivatives(Vec2 uv) const {
    return atlas_.derivatives(face_, glm::clamp(uv, cell_.min, cell_.max));
  }

  const PlacedAtlas& atlas_;
  std::int32_t face_;
  ParameterBox cell_;
};

/// (u,v) on the way from one state to another `length` further, `gone` of it travelled: the cubic
/// with the velocities at both ends.
Vec2 between(const PathState& from, const PathState& to, double length, double gone);

}  // namespace burin::detail
