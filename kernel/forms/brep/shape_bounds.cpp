#include "shape_bounds.h"

#include <burin/base/parallel.h>

#include "contain.h"
#include "occt_vec.h"
#include "triangles/trim_polygon.h"

#include <GeomAbs_CurveType.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace burin {
namespace {

/// The farthest point is searched until its parameter is known to 1e-4 of a sample's distance: the
/// extent then to 1e-8 of what a sample may miss.
constexpr int kGoldenSteps = 20;

template <class Function>
double maximise(const Function& f, double a, double b) {
  constexpr double kGolden = 0.6180339887498949;
  double x = b - kGolden * (b - a), y = a + kGolden * (b - a);
  double fx = f(x), fy = f(y), best = std::max({f(a), f(b), fx, fy});
  for (int i = 0; i < kGoldenSteps; ++i) {
    if (fx > fy) {
      b = y, y = x, fy = fx;
      x = b - kGolden * (b - a);
      best = std::max(best, fx = f(x));
    } else {
      a = x, x = y, fx = fy;
      y = a + kGolden * (b - a);
      best = std::max(best, fy = f(y));
    }
  }
  return best;
}

bool is_line(Handle(Geom_Curve) curve) {
  if (const auto t = Handle(Geom_TrimmedCurve)::DownCast(curve); !t.IsNull()) {
    curve = t->BasisCurve();
  }
  return curve->IsKind(STANDARD_TYPE(Geom_Line));
}

std::size_t samples_of(const Handle(Geom_Curve) & curve) {
  const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve);
  if (spline.IsNull()) return 13;  // of a circle, every 30 degrees
  return static_cast<std::size_t>(std::clamp(4 * (spline->NbKnots() - 1) + 1, 9, 129));
}

/// Samples in one direction of a face: every 30 degrees of round faces, 4 a span of splines.
int samples_of(const Chart& chart, int direction, double from, double to) {
  const double turn = chart.period()[direction];
  const int turns = std::clamp(static_cast<int>(std::ceil((to - from) / 0.5236)) + 1, 3, 16);
  if (chart.kind() == FaceKind::Sphere) return turns;
  int spans = 1;
  for (const double b : chart.breaks(direction, 2)) spans += b > from && b < to;
  const int samples = std::clamp(4 * spans, turn > 0 ? 12 : 6, 40);
  // The meridians of other surfaces of revolution than tori have parameters of any kind.
  return chart.kind() == FaceKind::Torus ? std::max(turns, samples) : samples;
}

bool ends_at_edges(const Chart& chart) {
  const FaceKind k = chart.kind();
  return k == FaceKind::Plane || k == FaceKind::Cylinder || k == FaceKind::Cone;
}

struct Grid {
  std::vector<Vec3> points;
  std::vector<Vec2> uv;
  Vec2 cell{0};
  double slack = 0;
};

/// How far S lies from the middle of a cell's diagonal, at the most.
double missed(const Chart& chart, Vec2 at, Vec2 cell) {
  const Vec3 p = chart.position(at), q = chart.position(at + cell);
  return glm::length(chart.position(at + 0.5 * cell) - 0.5 * (p + q));
}

Grid sample_face(const ModelParts& parts, std::int32_t face) {
  Grid grid;
  const ModelFace& f = parts.faces[static_cast<std::size_t>(face)];
  if (!f.chart || ends_at_edges(*f.chart)) return grid;
  const TrimPolygon trim(parts, face);
  if (trim.empty()) return grid;
  const Box2& box = trim.box();
  const int nu = samples_of(*f.chart, 0, box.min.x, box.max.x);
  const int nv = samples_of(*f.chart, 1, box.min.y, box.max.y);
  grid.cell = box.size() / Vec2(nu, nv);
  for (int j = 0; j < nv; ++j) {
    const double v = box.min.y + (j + 0.5) * grid.cell.y;
    const std::vector<double> u = trim.crossings(v);
    for (int i = 0; i < nu; ++i) {
      const Vec2 at(box.min.x + (i + 0.5) * grid.cell.x, v);
      if ((std::ranges::upper_bound(u, at.x) - u.begin()) % 2 == 0) continue;
      grid.uv.push_back(at);
      grid.points.push_back(f.chart->position(at));
      grid.slack = std::max(grid.slack, missed(*f.chart, at - 0.5 * grid.cell, grid.cell));
    }
  }
  grid.slack *= 2;
  return grid;
}

}  // namespace

ShapeBounds::ShapeBounds(const ModelParts& parts) {
  for (std::size_t e = 0; e < parts.edges.size(); ++e) {
    if (parts.edges[e].coedges.empty()) continue;
    for (const std::int32_t v : parts.edges[e].vertex) {
      if (v >= 0) points_.push_back(parts.vertices[static_cast<std::size_t>(v)]);
    }
    contained([&] { sample_edge(parts, static_cast<std::int32_t>(e)); });
  }
  for (const ModelFace& f : parts.faces) {
    points_.insert(points_.end(), f.given.positions.begin(), f.given.positions.end());
  }
  std::vector<Grid> grids(parts.faces.size());
  parallel_for(grids.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      survived([&] { grids[f] = sample_face(parts, static_cast<std::int32_t>(f)); });
    }
  });
  for (std::size_t f = 0; f < grids.size(); ++f) {
    const Grid& g = grids[f];
    if (g.points.empty()) continue;
    faces_.push_back(
        {static_cast<std::int32_t>(f), face_points_.size(), g.points.size(), g.cell, g.slack});
    face_points_.insert(face_points_.end(), g.points.begin(), g.points.end());
    face_uv_.insert(face_uv_.end(), g.uv.begin(), g.uv.end());
  }
}

void ShapeBounds::sample_edge(const ModelParts& parts, std::int32_t edge) {
  const ModelEdge& e = parts.edges[static_cast<std::size_t>(edge)];
  if (e.curve.IsNull() || is_line(e.curve)) return;
  CurveSamples s;
  s.edge = edge;
  s.first = points_.size();
  s.count = samples_of(e.curve);
  const double step = (e.last - e.first) / static_cast<double>(s.count - 1);
  Vec3 last(0);
  for (std::size_t i = 0; i < s.count; ++i) {
    const double t = e.first + step * static_cast<double>(i);
    const Vec3 p = to_vec(e.curve->Value(t));
    points_.push_back(p);
    if (i > 0) {
      const Vec3 middle = to_vec(e.curve->Value(t - 0.5 * step));
      s.slack = std::max(s.slack, 2 * glm::length(middle - 0.5 * (p + last)));
    }
    last = p;
  }
  curves_.push_back(s);
}

namespace {

/// The sample farthest along `d` of `count`.
std::size_t farthest(const Vec3* p, std::size_t count, Vec3 d) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < count; ++i) {
    if (glm::dot(p[i], d) > glm::dot(p[best], d)) best = i;
  }
  return best;
}

double farthest_on_curve(const ModelEdge& e, std::size_t count, std::size_t at, Vec3 d) {
  const double step = (e.last - e.first) / static_cast<double>(count - 1);
  const double t = e.first + step * static_cast<double>(at);
  return maximise([&](double s) { return glm::dot(to_vec(e.curve->Value(s)), d); },
                  std::max(t - step, e.first), std::min(t + step, e.last));
}

/// Whether a point is in the face, also a period beside its parameters.
bool covers(const TrimPolygon& trim, Vec2 at, Vec2 period) {
  for (const double dv : {0.0, period.y, -period.y}) {
    const std::vector<double> u = trim.crossings(at.y + dv);
    for (const double du : {0.0, period.x, -period.x}) {
      if ((std::ranges::upper_bound(u, at.x + du) - u.begin()) % 2 != 0) return true;
    }
  }
  return false;
}

/// Where a face is farthest near a sample, unless that is at its border: its edges know that. The
/// search alternates between the directions and stays within a cell of the sample.
std::optional<double> farthest_inside(const ModelParts& parts, std::int32_t face, Vec2 sample,
                                      Vec2 cell, Vec3 d) {
  const Chart& chart = *parts.faces[static_cast<std::size_t>(face)].chart;
  double best = -std::numeric_limits<double>::infinity();
  Vec2 at = sample;
  const Vec2 low = at - cell, high = at + cell;
  for (int round = 0; round < 6; ++round) {
    const int k = round % 2;
    const auto f = [&](double s) {
      Vec2 uv = at;
      uv[k] = s;
      const double value = glm::dot(chart.position(uv), d);
      if (value > best) {
        best = value;
        at = uv;
      }
      return value;
    };
    maximise(f, low[k], high[k]);
  }
  // A surface goes on where its face has been trimmed.
  if (!covers(TrimPolygon(parts, face), at, chart.period())) return std::nullopt;
  return best;
}

}  // namespace

Box3 ShapeBounds::box(const ModelParts& parts, const Mat3& axes) const {
  Box3 box;
  for (const Vec3& p : points_) box.add(axes * p);
  for (const Vec3& p : face_points_) box.add(axes * p);
  const Mat3 rows = glm::transpose(axes);
  for (int k = 0; k < 3; ++k) {
    for (const double sign : {1.0, -1.0}) {
      const Vec3 d = sign * rows[k];
      const double length = glm::length(d);
      double far = sign > 0 ? box.max[k] : -box.min[k];
      for (const CurveSamples& c : curves_) {
        const std::size_t i = farthest(&points_[c.first], c.count, d);
        if (glm::dot(points_[c.first + i], d) + c.slack * length <= far) continue;
        const ModelEdge& e = parts.edges[static_cast<std::size_t>(c.edge)];
        contained([&] { far = std::max(far, farthest_on_curve(e, c.count, i, d)); });
      }
      for (const FaceSamples& f : faces_) {
        const std::size_t i = farthest(&face_points_[f.first], f.count, d);
        if (glm::dot(face_points_[f.first + i], d) + f.slack * length <= far) continue;
        survived([&] {
          const Vec2 sample = face_uv_[f.first + i];
          far = std::max(far, farthest_inside(parts, f.face, sample, f.cell, d).value_or(far));
        });
      }
      (sign > 0 ? box.max : box.min)[k] = sign * far;
    }
  }
  return box;
}

}  // namespace burin
