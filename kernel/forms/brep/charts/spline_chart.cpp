#include <burin/base/error.h>
#include <burin/forms/charted/nurbs.h>

#include "occt_vec.h"
#include "surface_chart.h"

#include <Geom_BSplineSurface.hxx>
#include <Geom_BezierSurface.hxx>
#include <Standard_Failure.hxx>

#include <cmath>

namespace burin {
namespace {

/// Whether all control points lie in one plane, within rounding of the coordinates.
bool is_flat(const NurbsData& data) {
  Box3 box;
  for (const Vec3& p : data.points) box.add(p);
  const double rounding = 1e-9 * box.diagonal();
  // The two points farthest from the first and from the line span the plane.
  const Vec3 o = data.points.front();
  Vec3 a(0);
  for (const Vec3& p : data.points) {
    if (glm::dot(p - o, p - o) > glm::dot(a, a)) a = p - o;
  }
  Vec3 n(0);
  for (const Vec3& p : data.points) {
    const Vec3 c = glm::cross(a, p - o);
    if (glm::dot(c, c) > glm::dot(n, n)) n = c;
  }
  n = normalize_or(n, Vec3(0));
  for (const Vec3& p : data.points) {
    if (std::abs(glm::dot(n, p - o)) > rounding) return false;
  }
  return true;
}

void add_knots(std::vector<double>& out, const TColStd_Array1OfReal& flat) {
  out.reserve(static_cast<std::size_t>(flat.Length()));
  for (const double k : flat) out.push_back(k);
}

/// Both kinds of surface name their poles alike.
template <class Spline>
void add_poles(NurbsData& data, const Spline& s) {
  data.degree_u = s.UDegree();
  data.degree_v = s.VDegree();
  data.count_u = s.NbUPoles();
  data.count_v = s.NbVPoles();
  const bool rational = s.IsURational() || s.IsVRational();
  for (int i = 1; i <= data.count_u; ++i) {
    for (int j = 1; j <= data.count_v; ++j) {
      data.points.push_back(to_vec(s.Pole(i, j)));
      if (rational) data.weights.push_back(s.Weight(i, j));
    }
  }
}

NurbsData data_of(const Geom_BSplineSurface& spline) {
  Handle(Geom_BSplineSurface) s = Handle(Geom_BSplineSurface)::DownCast(spline.Copy());
  NurbsData data;
  data.periodic_u = s->IsUPeriodic();
  data.periodic_v = s->IsVPeriodic();
  if (data.periodic_u) s->SetUNotPeriodic();
  if (data.periodic_v) s->SetVNotPeriodic();
  add_poles(data, *s);
  add_knots(data.knots_u, s->UKnotSequence());
  add_knots(data.knots_v, s->VKnotSequence());
  return data;
}

NurbsData data_of(const Geom_BezierSurface& s) {
  NurbsData data;
  add_poles(data, s);
  const auto knots = [](int degree) {
    std::vector<double> k(static_cast<std::size_t>(degree) + 1, 0.0);
    k.resize(2 * k.size(), 1.0);
    return k;
  };
  data.knots_u = knots(data.degree_u);
  data.knots_v = knots(data.degree_v);
  return data;
}

}  // namespace

std::shared_ptr<const Chart> make_spline_chart(const Handle(Geom_Surface) & surface) {
  try {
    NurbsData data;
    if (const auto b = Handle(Geom_BSplineSurface)::DownCast(surface); !b.IsNull()) {
      data = data_of(*b);
    } else if (const auto z = Handle(Geom_BezierSurface)::DownCast(surface); !z.IsNull()) {
      data = data_of(*z);
    } else {
      return nullptr;
    }
    const FaceKind kind = is_flat(data) ? FaceKind::Plane : FaceKind::Freeform;
    return make_nurbs_chart(std::move(data), kind);
  } catch (const Standard_Failure&) {
  } catch (const GeometryError&) {
    // OCCT evaluates also what the kernel's own evaluator refuses.
  }
  return nullptr;
}

}  // namespace burin
