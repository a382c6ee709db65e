// Parametric forms. Budgets a core: second-order evaluations of a bicubic B-spline 10 M/s along a
// stroke, 5 M/s at random places; 10,000 points of Algorithm 1 on the horn in 10 ms.

#include <burin/forms/charted/coverage.h>
#include <burin/forms/charted/nurbs.h>

#include <benchmark/benchmark.h>
#include <burin_test/horn.h>
#include <burin_test/nurbs_shapes.h>

#include <limits>
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
    const std::size_t line = i / 300;
    const double t = static_cast<double>(i % 300) / 300, c = static_cast<double>(line) / 220;
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
BENCHMARK_CAPTURE(evaluate, degree5_stroke_position,
                  test::random_nurbs(5, 5, 20, 20, false, true, 1), false, false);
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

void bound(benchmark::State& state, const NurbsData& data, double tolerance = 0.05) {
  const RunContext context;
  const auto chart = make_nurbs_chart(data);
  AreaBound b;
  for (auto _ : state) b = area_bound(*chart, context, tolerance);
  state.counters["bound"] = b.value;
  state.counters["loose"] = b.attained > 0 ? b.value / b.attained : 0;
  state.counters["splits"] = static_cast<double>(b.subdivisions);
}
constexpr double kAsItIs = std::numeric_limits<double>::infinity();
BENCHMARK_CAPTURE(bound, horn, test::horn_nurbs());
BENCHMARK_CAPTURE(bound, horn_plain, test::horn_nurbs(), kAsItIs);
BENCHMARK_CAPTURE(bound, torus, test::torus_nurbs(3, 1));
BENCHMARK_CAPTURE(bound, torus_plain, test::torus_nurbs(3, 1), kAsItIs);
BENCHMARK_CAPTURE(bound, sphere, test::sphere_nurbs(1));
BENCHMARK_CAPTURE(bound, sphere_plain, test::sphere_nurbs(1), kAsItIs);
BENCHMARK_CAPTURE(bound, rational, bicubic(true));
BENCHMARK_CAPTURE(bound, rational_plain, bicubic(true), kAsItIs);

void cover(benchmark::State& state, const NurbsData& data, const CoverageOptions& options) {
  const RunContext context;
  const auto chart = make_nurbs_chart(data);
  Coverage c;
  for (auto _ : state) c = cover_chart(*chart, options, context);
  state.counters["points"] = static_cast<double>(c.points.size());
  state.counters["candidates"] =
      static_cast<double>(c.candidates) / static_cast<double>(c.points.size());
  state.counters["radius"] = c.covering_radius;
}

CoverageOptions coverage(std::size_t count, bool measure, double spacing = 0) {
  CoverageOptions options;
  options.count = count;
  options.measure = measure;
  options.spacing = spacing;
  return options;
}
BENCHMARK_CAPTURE(cover, horn_10k, test::horn_nurbs(), coverage(10'000, false))->UseRealTime();
BENCHMARK_CAPTURE(cover, horn_10k_measured, test::horn_nurbs(), coverage(10'000, true))
    ->UseRealTime();
BENCHMARK_CAPTURE(cover, horn_discs, test::horn_nurbs(), coverage(1'000'000, true, 1.2))
    ->UseRealTime();
BENCHMARK_CAPTURE(cover, torus_10k, test::torus_nurbs(3, 1), coverage(10'000, false))
    ->UseRealTime();
BENCHMARK_CAPTURE(cover, sphere_10k, test::sphere_nurbs(1), coverage(10'000, false))->UseRealTime();

}  // namespace
}  // namespace burin
