#pragma once
/// One parametric surface S(u,v) and its local geometry.

#include <burin/base/placement.h>
#include <burin/base/vec.h>
#include <burin/surface/surface.h>

#include <vector>

namespace burin {

/// S and its partial derivatives up to the second order, in model mm and parameters: `u` is dS/du,
/// `uv` is d2S/du dv.
struct SurfaceDerivatives {
  Vec3 p{0}, u{0}, v{0}, uu{0}, uv{0}, vv{0};
};

struct ParameterBox {
  Vec2 min{0}, max{1};
  Vec2 size() const { return max - min; }
  Vec2 center() const { return 0.5 * (min + max); }
};

/// S(u,v) over a rectangle. Immutable; every function may be called from many threads and does not
/// allocate.
class Chart {
 public:
  Chart() = default;
  Chart(const Chart&) = delete;
  Chart& operator=(const Chart&) = delete;
  virtual ~Chart() = default;

  virtual Vec3 position(Vec2 uv) const = 0;
  virtual SurfaceDerivatives derivatives(Vec2 uv) const = 0;
  /// Where S is defined. Outside it: periodic directions wrap, others are clamped to the nearest
  /// border.
  virtual ParameterBox domain() const = 0;
  /// Length of the period in u and in v; 0 where the direction is not periodic.
  virtual Vec2 period() const { return Vec2(0); }
  virtual FaceKind kind() const { return FaceKind::Freeform; }
  /// The largest |Su x Sv| over the domain, where a formula gives it; else 0.
  virtual double largest_area() const { return 0; }
  /// Parameters inside the domain at which fewer than `order` derivatives of S are continuous
  /// (knots of high multiplicity), ascending: `direction` 0 = u, 1 = v. Derivatives there are those
  /// of the upper side.
  virtual std::vector<double> breaks([[maybe_unused]] int direction,
                                     [[maybe_unused]] int order) const {
    return {};
  }
};

/// The derivatives of the placed surface.
inline SurfaceDerivatives placed(const Placement& by, const SurfaceDerivatives& d) {
  return {by.point(d.p),   by.vector(d.u),  by.vector(d.v),
          by.vector(d.uu), by.vector(d.uv), by.vector(d.vv)};
}

/// The unit normal Su x Sv (turned round where `reversed`). Where a partial vanishes (poles,
/// collapsed sides), both do, or they are parallel: its limit by second derivatives, at the tip of
/// a cone the limit along the ruling u = `uv.x`; the zero vector where these vanish, too. The limit
/// is taken from the side of `domain_center`: from inside.
/// @cite doCarmo1976
Vec3 chart_normal(const SurfaceDerivatives& d, bool reversed, Vec2 uv, Vec2 domain_center);

/// First and second fundamental forms, principal curvatures and directions: exact. `size` is the
/// size of the part in model mm: curvatures of radius over 1000 sizes count as none. Confidence is
/// |k1-k2| / (|k1|+|k2|), and 0 at umbilics and where the surface is flat or degenerate.
/// @cite doCarmo1976
Frame chart_frame(const SurfaceDerivatives& d, Vec3 unit_normal, FaceKind kind, double size);

/// The components (alpha, beta) of a tangent t = alpha Su + beta Sv by the two rows of the system
/// that are left when that of the largest component of the normal is dropped. Returns false where
/// the partials are (nearly) parallel. @cite Elber1998 (equations 7 and 9)
bool tangent_components(const SurfaceDerivatives& d, Vec3 tangent, Vec2& components);

}  // namespace burin
