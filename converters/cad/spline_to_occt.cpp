#include "spline_to_occt.h"

#include <burin/base/error.h>

#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// OCCT's knots: each once, with how often it stands there.
struct Knots {
  TColStd_Array1OfReal values;
  TColStd_Array1OfInteger multiplicities;
  double first, last;  // of the domain
};

Knots knots_of(const std::vector<double>& flat, int degree, int count) {
  if (degree > Geom_BSplineSurface::MaxDegree()) {
    throw GeometryError(fmt::format("its degree is {}, trimmed surfaces and their curves go to {}",
                                    degree, Geom_BSplineSurface::MaxDegree()));
  }
  // Knots nearer than this are one for OCCT's tools.
  constexpr double kSame = 1e-12;
  const double first = flat[static_cast<std::size_t>(degree)];
  const double last = flat[static_cast<std::size_t>(count)];
  std::vector<std::pair<double, int>> knots;
  for (const double k : flat) {
    if (knots.empty() || k - knots.back().first > kSame * (last - first)) {
      knots.emplace_back(k, 0);
    }
    ++knots.back().second;
  }
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const bool end = i == 0 || i + 1 == knots.size();
    if (knots[i].second > degree + (end ? 1 : 0)) {
      throw GeometryError(
          fmt::format("the knot {} occurs {} times, at which a spline of order {} breaks",
                      knots[i].first, knots[i].second, degree + 1));
    }
  }
  const int n = static_cast<int>(knots.size());
  Knots out{TColStd_Array1OfReal(1, n), TColStd_Array1OfInteger(1, n), first, last};
  for (int i = 1; i <= n; ++i) {
    std::tie(out.values(i), out.multiplicities(i)) = knots[static_cast<std::size_t>(i - 1)];
  }
  return out;
}

}  // namespace

Handle(Geom_BSplineSurface) occt_surface(const NurbsData& data) {
  const Knots u = knots_of(data.knots_u, data.degree_u, data.count_u);
  const Knots v = knots_of(data.knots_v, data.degree_v, data.count_v);
  TColgp_Array2OfPnt poles(1, data.count_u, 1, data.count_v);
  TColStd_Array2OfReal weights(1, data.count_u, 1, data.count_v);
  for (int i = 0; i < data.count_u; ++i) {
    for (int j = 0; j < data.count_v; ++j) {
      const auto k = static_cast<std::size_t>(i) * static_cast<std::size_t>(data.count_v) +
                     static_cast<std::size_t>(j);
      const Vec3& p = data.points[k];
      poles(i + 1, j + 1) = gp_Pnt(p.x, p.y, p.z);
      weights(i + 1, j + 1) = data.weights.empty() ? 1.0 : data.weights[k];
    }
  }
  Handle(Geom_BSplineSurface) surface =
      new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities,
                              v.multiplicities, data.degree_u, data.degree_v);
  surface->Segment(u.first, u.last, v.first, v.last);
  return surface;
}

Handle(Geom2d_BSplineCurve) occt_curve(const TrimCurve& curve) {
  const int count = static_cast<int>(curve.points.size());
  const Knots t = knots_of(curve.knots, curve.degree, count);
  TColgp_Array1OfPnt2d poles(1, count);
  TColStd_Array1OfReal weights(1, count);
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    poles(i + 1) = gp_Pnt2d(curve.points[k].x, curve.points[k].y);
    weights(i + 1) = curve.weights.empty() ? 1.0 : curve.weights[k];
  }
  Handle(Geom2d_BSplineCurve) out =
      new Geom2d_BSplineCurve(poles, weights, t.values, t.multiplicities, curve.degree);
  out->Segment(t.first, t.last);
  return out;
}

}  // namespace burin
