#include "pcurve.h"

#include "occt_vec.h"

#include <Geom2d_Line.hxx>
#include <Geom2d_TrimmedCurve.hxx>
#include <Standard_Failure.hxx>

#include <cmath>

namespace burin {

Pcurve::Pcurve(const Handle(Geom2d_Curve) & curve, double first, double last, double edge_first,
               double edge_last)
    : curve_(curve) {
  if (curve_.IsNull()) return;
  if (edge_last != edge_first && (first != edge_first || last != edge_last)) {
    scale_ = (last - first) / (edge_last - edge_first);
    shift_ = first - scale_ * edge_first;
  }
  Handle(Geom2d_Curve) basis = curve_;
  if (const auto t = Handle(Geom2d_TrimmedCurve)::DownCast(basis); !t.IsNull()) {
    basis = t->BasisCurve();
  }
  const auto line = Handle(Geom2d_Line)::DownCast(basis);
  if (line.IsNull()) return;
  straight_ = true;
  const gp_Dir2d d = line->Direction();
  direction_ = scale_ * Vec2(d.X(), d.Y());
  origin_ = to_vec(line->Location()) + shift_ * Vec2(d.X(), d.Y());
}

Vec2 Pcurve::at(double t) const {
  if (straight_) return origin_ + t * direction_;
  try {
    return to_vec(curve_->Value(scale_ * t + shift_));
  } catch (const Standard_Failure&) {
    // Offset curves have no place where their basis stands still; a little farther they have.
    const double nudged = t + 1e-7 * (curve_->LastParameter() - curve_->FirstParameter());
    return to_vec(curve_->Value(scale_ * nudged + shift_));
  }
}

}  // namespace burin
