#include "absurd_numbers.h"

#include "source.h"

#include <StepGeom_BSplineCurveWithKnots.hxx>
#include <StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve.hxx>
#include <StepGeom_BSplineSurfaceWithKnots.hxx>
#include <StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface.hxx>
#include <StepGeom_CartesianPoint.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace burin {
namespace {

using Entity = Handle(Standard_Transient);
using Found = std::optional<double>;

/// Beyond it a number is taken for rubbish. Coordinates: OCCT's algorithms take time in proportion
/// to them where curves are periodic. Knots: from 1e12 on it made no faces, and from 1e308 on it
/// looked for the same parameter of two curves for ever.
constexpr double kFarthest = 1e12;

bool absurd(double x) { return !(std::abs(x) <= kFarthest); }

Found absurd_coordinate(const Entity& entity) {
  const auto point = Handle(StepGeom_CartesianPoint)::DownCast(entity);
  for (int k = 1; !point.IsNull() && k <= point->NbCoordinates(); ++k) {
    if (absurd(point->CoordinatesValue(k))) return point->CoordinatesValue(k);
  }
  return {};
}

Found first_absurd(const Handle(TColStd_HArray1OfReal) & knots) {
  for (int i = 1; !knots.IsNull() && i <= knots->Length(); ++i) {
    if (absurd(knots->Value(i))) return knots->Value(i);
  }
  return {};
}

Found absurd_knot_of_curve(const Entity& entity) {
  using Rational = StepGeom_BSplineCurveWithKnotsAndRationalBSplineCurve;
  auto curve = Handle(StepGeom_BSplineCurveWithKnots)::DownCast(entity);
  if (const auto rational = Handle(Rational)::DownCast(entity)) {
    curve = rational->BSplineCurveWithKnots();
  }
  return curve.IsNull() ? Found() : first_absurd(curve->Knots());
}

Found absurd_knot_of_surface(const Entity& entity) {
  using Rational = StepGeom_BSplineSurfaceWithKnotsAndRationalBSplineSurface;
  auto surface = Handle(StepGeom_BSplineSurfaceWithKnots)::DownCast(entity);
  if (const auto rational = Handle(Rational)::DownCast(entity)) {
    surface = rational->BSplineSurfaceWithKnots();
  }
  if (surface.IsNull()) return {};
  const Found u = first_absurd(surface->UKnots());
  return u ? u : first_absurd(surface->VKnots());
}

}  // namespace

void refuse_absurd_numbers(const StepData_StepModel& model, const Source& source) {
  const auto refuse = [&](const Entity& entity, const char* what, const Found& found) {
    if (!found) return;
    source.fail(fmt::format("has {} {:g} (#{}); export the model again", what, *found,
                            model.IdentLabel(entity)));
  };
  for (int i = 1; i <= model.NbEntities(); ++i) {
    const Entity& entity = model.Value(i);
    refuse(entity, "a point with the coordinate", absurd_coordinate(entity));
    refuse(entity, "a curve with the knot", absurd_knot_of_curve(entity));
    refuse(entity, "a surface with the knot", absurd_knot_of_surface(entity));
  }
}

}  // namespace burin
