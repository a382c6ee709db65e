// Parametric forms. Budgets a core: second-order evaluations of a bicubic B-spline 10 M/s along a
// stroke, 5 M/s at random places; 10,000 points of Algorithm 1 on the horn in 10 ms.

#include <burin/forms/parametric/nurbs.h>

#include <benchmark/benchmark.h>
#include <burin_test/nurbs_shapes.h>

#include <vector>

namespace burin {
namespace {

std::vector<Vec2> random_places(const Chart& chart) {
  const Rng rng(1);
  std::vector<Vec2> places(1 << 16);
  for (std::size_t i = 0; i < places.size(); ++i) {
    places[i] = chart.domain().min +
                Vec2(rng.uniform(2 * i), rng.uniform(2 * i + 1)) * chart.domain().size();
  }
  return places;
}

/// Steps of a 300th of the domain along slanted lines, as strokes take them.
std::vector<Vec2> stroke_places(const Chart& chart) {
  std::vector<Vec2> places(1 << 16);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double t = static_cast<double>(i % 300) / 300, c = static_cast<double>(i / 300) / 220;
    places[i] = chart.domain().min + Vec2(t, 0.5 * (c + t)) * chart.domain().size();
  }
  return places;
}

void evaluate(benchmark::State& state, const NurbsData& data, bool random, bool second = true) {
  const auto chart = make_nurbs_chart(data);
  const std::vector<Vec2> places = random ? random_places(*chart) : stroke_places(*chart);
  for (auto _ : state) {
    Vec3 sum(0);
    for (const Vec2 uv : places) {
      if (second) {
        const SurfaceDerivatives d = chart->derivatives(uv);
        sum += d.uu + d.uv + d.vv + d.p + d.u + d.v;
      } else {
        sum += chart->position(uv);
      }
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(places.size()));
}

NurbsData bicubic(bool rational) { return test::random_nurbs(3, 3, 20, 20, rational, true, 1); }

BENCHMARK_CAPTURE(evaluate, bicubic_stroke, bicubic(false), false);
BENCHMARK_CAPTURE(evaluate, bicubic_random, bicubic(false), true);
BENCHMARK_CAPTURE(evaluate, bicubic_random_position, bicubic(false), true, false);
BENCHMARK_CAPTURE(evaluate, rational_bicubic_stroke, bicubic(true), false);
BENCHMARK_CAPTURE(evaluate, rational_bicubic_random, bicubic(true), true);
BENCHMARK_CAPTURE(evaluate, torus_stroke, test::torus_nurbs(3, 1), false);
BENCHMARK_CAPTURE(evaluate, torus_random, test::torus_nurbs(3, 1), true);
BENCHMARK_CAPTURE(evaluate, degree5_stroke, test::random_nurbs(5, 5, 20, 20, false, true, 1),
                  false);
BENCHMARK_CAPTURE(evaluate, degree9x3_rational_stroke,
                  test::random_nurbs(9, 3, 20, 20, true, true, 1), false);

void chart_frames(benchmark::State& state) {
  const auto chart = make_nurbs_chart(bicubic(false));
  const std::vector<Vec2> places = stroke_places(*chart);
  for (auto _ : state) {
    double sum = 0;
    for (const Vec2 uv : places) {
      const SurfaceDerivatives d = chart->derivatives(uv);
      const Vec3 n = chart_normal(d, false, uv, chart->domain().center());
      sum += chart_frame(d, n, FaceKind::Freeform, 30).confidence;
    }
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(places.size()));
}
BENCHMARK(chart_frames);

}  // namespace
}  // namespace burin
