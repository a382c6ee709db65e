#include "occt_vec.h"
#include "surface_chart.h"

#include <GeomAbs_Shape.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Line.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_SurfaceOfRevolution.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// What strokes may take a surface for: extruded lines are planes, extruded circles cylinders;
/// surfaces of revolution have circles and meridians for lines of curvature, as tori do.
FaceKind kind_of(const Handle(Geom_Surface) & surface) {
  if (surface->IsKind(STANDARD_TYPE(Geom_SurfaceOfRevolution))) return FaceKind::Torus;
  const auto extrusion = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(surface);
  if (extrusion.IsNull()) return FaceKind::Freeform;
  Handle(Geom_Curve) curve = extrusion->BasisCurve();
  if (const auto t = Handle(Geom_TrimmedCurve)::DownCast(curve); !t.IsNull()) {
    curve = t->BasisCurve();
  }
  if (curve->IsKind(STANDARD_TYPE(Geom_Line))) return FaceKind::Plane;
  const auto circle = Handle(Geom_Circle)::DownCast(curve);
  if (circle.IsNull()) return FaceKind::Freeform;
  const bool right = circle->Circ().Axis().Direction().IsParallel(extrusion->Direction(), 1e-9);
  return right ? FaceKind::Cylinder : FaceKind::Freeform;
}

class EvaluatedChart final : public Chart {
 public:
  EvaluatedChart(const Handle(Geom_Surface) & surface, const ParameterBox& used)
      : surface_(surface), kind_(kind_of(surface)) {
    surface->Bounds(domain_.min.x, domain_.max.x, domain_.min.y, domain_.max.y);
    for (int k = 0; k < 2; ++k) {
      if (Precision::IsInfinite(domain_.min[k])) domain_.min[k] = used.min[k];
      if (Precision::IsInfinite(domain_.max[k])) domain_.max[k] = used.max[k];
    }
    if (surface->IsUPeriodic()) period_.x = surface->UPeriod();
    if (surface->IsVPeriodic()) period_.y = surface->VPeriod();
    find_breaks();
  }

  Vec3 position(Vec2 uv) const override {
    uv = inside(uv);
    try {
      return to_vec(surface_->Value(uv.x, uv.y));
    } catch (const Standard_Failure&) {
      return to_vec(surface_->Value(nudged(uv).x, nudged(uv).y));
    }
  }
  SurfaceDerivatives derivatives(Vec2 uv) const override {
    uv = inside(uv);
    try {
      return second_order(uv);
    } catch (const Standard_Failure&) {
    }
    try {
      return second_order(nudged(uv));
    } catch (const Standard_Failure&) {
    }
    SurfaceDerivatives d;
    d.p = position(uv);
    return d;
  }
  ParameterBox domain() const override { return domain_; }
  Vec2 period() const override { return period_; }
  FaceKind kind() const override { return kind_; }
  std::vector<double> breaks(int direction, int order) const override {
    return breaks_[direction != 0][order > 1];
  }

 private:
  SurfaceDerivatives second_order(Vec2 uv) const {
    gp_Pnt p;
    gp_Vec u, v, uu, vv, mixed;
    surface_->D2(uv.x, uv.y, p, u, v, uu, vv, mixed);
    return {to_vec(p), to_vec(u), to_vec(v), to_vec(uu), to_vec(mixed), to_vec(vv)};
  }
  Vec2 inside(Vec2 uv) const {
    for (int k = 0; k < 2; ++k) {
      if (period_[k] == 0) uv[k] = std::clamp(uv[k], domain_.min[k], domain_.max[k]);
    }
    return uv;
  }
  /// A millionth of the domain nearer to its centre: away from poles of offsets and revolutions.
  Vec2 nudged(Vec2 uv) const { return uv + 1e-6 * (domain_.center() - uv); }
  void find_breaks() {
    const GeomAdaptor_Surface adaptor(surface_);
    for (const int k : {0, 1}) {
      for (const int smooth : {0, 1}) {
        const GeomAbs_Shape order = smooth ? GeomAbs_C2 : GeomAbs_C1;
        try {
          const int n = k ? adaptor.NbVIntervals(order) : adaptor.NbUIntervals(order);
          if (n < 2) continue;
          TColStd_Array1OfReal at(1, n + 1);
          k ? adaptor.VIntervals(at, order) : adaptor.UIntervals(at, order);
          for (int i = 2; i <= n; ++i) breaks_[k][smooth].push_back(at(i));
        } catch (const Standard_Failure&) {
        }
      }
    }
  }

  Handle(Geom_Surface) surface_;
  FaceKind kind_;
  ParameterBox domain_;
  Vec2 period_{0};
  /// For each direction those of the first order, and those of the second.
  std::vector<double> breaks_[2][2];
};

}  // namespace

std::shared_ptr<const Chart> make_evaluated_chart(const Handle(Geom_Surface) & surface,
                                                  const ParameterBox& used) {
  return std::make_shared<EvaluatedChart>(surface, used);
}

}  // namespace burin
