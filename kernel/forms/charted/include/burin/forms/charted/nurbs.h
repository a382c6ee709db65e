#pragma once
/// Bezier, B-spline and NURBS tensor-product surfaces, and S(u,v) given by functions.

#include <burin/forms/charted/chart.h>

#include <functional>
#include <memory>
#include <vector>

namespace burin {

/// A NURBS surface as data: degrees, knot vectors (clamped or not, size = count + degree + 1),
/// control points in row-major order (index = i * count_v + j, i along u) and weights (empty where
/// polynomial). The domain is knots[degree] to knots[count]. A direction is periodic where the two
/// sides across it coincide and parameters shall wrap (control points are repeated as the knots
/// need them). A Bezier patch has knots 0..0 1..1.
struct NurbsData {
  int degree_u = 0, degree_v = 0;
  std::vector<double> knots_u, knots_v;
  int count_u = 0, count_v = 0;
  std::vector<Vec3> points;
  std::vector<double> weights;
  bool periodic_u = false, periodic_v = false;
};

/// A chart that evaluates `data`. Spans are made ready once, so that it needs no cache and no
/// locks. Throws GeometryError that says what is wrong with the data (counts, descending knots,
/// weights that are not positive, numbers that are not finite, periods that do not close). Degrees
/// 1 to 60. Cost: 0.05 us per evaluation of the second order of a bicubic surface; memory: 0.5 kB
/// per bicubic span. @cite Piegl1997
std::shared_ptr<const Chart> make_nurbs_chart(NurbsData data, FaceKind kind = FaceKind::Freeform);

/// The data behind a chart made by make_nurbs_chart; nullptr for others.
const NurbsData* nurbs_data(const Chart& chart);

/// A Bezier patch of degrees (du, dv): points as in NurbsData.
NurbsData bezier_patch(int degree_u, int degree_v, std::vector<Vec3> points,
                       std::vector<double> weights = {});

struct FunctionChartOptions {
  ParameterBox domain;
  /// As Chart::period.
  Vec2 period{0};
};

/// S(u,v) given by a function that fills all derivatives, or by its position alone (derivatives by
/// central differences of the sixth order: some 1e-9 of the size off). The functions must be safe
/// to call from many threads.
std::shared_ptr<const Chart> make_function_chart(std::function<SurfaceDerivatives(Vec2)> evaluate,
                                                 const FunctionChartOptions& options);
std::shared_ptr<const Chart> make_function_chart(std::function<Vec3(Vec2)> position,
                                                 const FunctionChartOptions& options);

}  // namespace burin
