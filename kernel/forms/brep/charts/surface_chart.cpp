#include "surface_chart.h"

#include <burin/base/error.h>
#include <burin/forms/charted/analytic_chart.h>
#include <burin/forms/charted/nurbs.h>

#include "occt_vec.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Standard_Failure.hxx>

#include <cmath>

namespace burin {
namespace {

ChartAxes axes_of(const gp_Ax3& a) {
  return {to_vec(a.Location()), to_vec(a.XDirection()), to_vec(a.YDirection()),
          to_vec(a.Direction())};
}

std::shared_ptr<const Chart> make_analytic_chart(const Handle(Geom_Surface) & s,
                                                 const ParameterBox& used) {
  if (const auto p = Handle(Geom_Plane)::DownCast(s); !p.IsNull()) {
    return plane_chart(axes_of(p->Position()), used);
  }
  if (const auto c = Handle(Geom_CylindricalSurface)::DownCast(s); !c.IsNull()) {
    return cylinder_chart(axes_of(c->Position()), c->Radius(), used.min.y, used.max.y);
  }
  if (const auto c = Handle(Geom_ConicalSurface)::DownCast(s); !c.IsNull()) {
    return cone_chart(axes_of(c->Position()), c->RefRadius(), c->SemiAngle(), used.min.y,
                      used.max.y);
  }
  if (const auto b = Handle(Geom_SphericalSurface)::DownCast(s); !b.IsNull()) {
    return sphere_chart(axes_of(b->Position()), b->Radius());
  }
  if (const auto t = Handle(Geom_ToroidalSurface)::DownCast(s); !t.IsNull()) {
    return torus_chart(axes_of(t->Position()), t->MajorRadius(), t->MinorRadius());
  }
  return nullptr;
}

}  // namespace

Handle(Geom_Surface) without_trims(Handle(Geom_Surface) surface) {
  for (;;) {
    const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
    if (trimmed.IsNull()) return surface;
    surface = trimmed->BasisSurface();
  }
}

std::shared_ptr<const Chart> make_surface_chart(const Handle(Geom_Surface) & surface,
                                                const ParameterBox& used) {
  const Handle(Geom_Surface) s = without_trims(surface);
  // Straight directions have no end of their own: some room for steps that look over the border.
  const Vec2 room = 0.1 * used.size() + Vec2(1e-6);
  const ParameterBox roomy{used.min - room, used.max + room};
  if (auto chart = make_analytic_chart(s, roomy)) return chart;
  if (auto chart = make_spline_chart(s)) return chart;
  if (const auto offset = Handle(Geom_OffsetSurface)::DownCast(s); !offset.IsNull()) {
    // Offsets of elementary surfaces are elementary, in the same parameters.
    Handle(Geom_Surface) same;
    try {
      same = offset->Surface();
    } catch (const Standard_Failure&) {
    }
    if (!same.IsNull()) {
      if (auto chart = make_analytic_chart(without_trims(same), roomy)) return chart;
    }
  }
  return make_evaluated_chart(s, roomy);
}

}  // namespace burin
