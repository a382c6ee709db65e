// The mesh form and direction fields. Budgets on 2 cores: a smoothed field 0.8 s a million
// triangles and 0.1 s for 100,000; a query 0.3 us; marches 2 million triangles a second.

#include <burin/field/smoothed_field.h>
#include <burin/forms/mesh/mesh_form.h>

#include <benchmark/benchmark.h>
#include <burin_test/irregular.h>
#include <burin_test/shapes.h>

#include <memory>
#include <vector>

namespace burin {
namespace {

std::shared_ptr<const Surface> torus_of(std::int64_t triangles) {
  RunContext context;
  const auto n = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4));
  return MeshForm(test::torus(1, 0.4, 2 * n, n)).realise({}, context);
}

/// Strokes' points: 200 lines of 200 short steps.
struct Lines {
  std::vector<SurfacePoint> points;
  std::vector<Frame> frames;

  Lines(const Surface& s, const field::SmoothedField& f) {
    const RunContext context;
    for (SurfacePoint p : s.cover({.count = 200}, context)) {
      Vec3 came(0);
      for (int k = 0; k < 200; ++k) {
        points.push_back(p);
        frames.push_back(s.frame(p));
        const auto cross = f.cross({0, p, frames.back()});
        if (!cross) break;
        const Vec3 d = came == Vec3(0) ? cross->first : direction_along(*cross, came);
        const MarchStep step = s.march(p, d, 0.01);
        p = step.end;
        came = step.direction;
      }
    }
  }
};

void BM_SmoothedField(benchmark::State& state) {
  const auto s = torus_of(state.range(0));
  const RunContext context;
  for (auto _ : state) {
    const field::SmoothedField f({s.get()}, {}, context);
    benchmark::DoNotOptimize(&f);
  }
  state.counters["triangles"] = static_cast<double>(s->proxy().wedges.size());
}
BENCHMARK(BM_SmoothedField)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void BM_SmoothedFieldOfAScan(benchmark::State& state) {
  RunContext context;
  const auto s =
      MeshForm(
          test::noisy(test::irregular_torus(1, 0.4, static_cast<double>(state.range(0))), 0.05))
          .realise({}, context);
  for (auto _ : state) {
    const field::SmoothedField f({s.get()}, {}, context);
    benchmark::DoNotOptimize(&f);
  }
}
BENCHMARK(BM_SmoothedFieldOfAScan)->Arg(100'000)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_FieldQuery(benchmark::State& state) {
  const auto s = torus_of(state.range(0));
  const RunContext context;
  const field::SmoothedField f({s.get()}, {}, context);
  const Lines lines(*s, f);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(f.cross({0, lines.points[i], lines.frames[i]}));
    if (++i == lines.points.size()) i = 0;
  }
}
BENCHMARK(BM_FieldQuery)->Arg(100'000)->Arg(1'000'000);

void BM_Frame(benchmark::State& state) {
  const auto s = torus_of(state.range(0));
  const RunContext context;
  const field::SmoothedField f({s.get()}, {}, context);
  const Lines lines(*s, f);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(s->frame(lines.points[i]));
    if (++i == lines.points.size()) i = 0;
  }
}
BENCHMARK(BM_Frame)->Arg(100'000)->Arg(1'000'000);

void BM_March(benchmark::State& state) {
  const auto s = torus_of(state.range(0));
  const RunContext context;
  const auto points = s->cover({.count = 2000}, context);
  // A straight line of length L over triangles of area A crosses about 2.2 L / sqrt(2 A) of a
  // regular grid's.
  double area = 0, length = 0;
  for (std::uint32_t f = 0; f < s->proxy().wedges.size(); ++f) area += s->proxy().mesh.area(f);
  std::size_t i = 0;
  for (auto _ : state) {
    length += s->march(points[i], {1, 2, 3}, 1).length;
    if (++i == points.size()) i = 0;
  }
  const double cell = std::sqrt(2 * area / static_cast<double>(s->proxy().wedges.size()));
  state.counters["crossings"] =
      benchmark::Counter(2.2 * length / cell, benchmark::Counter::kIsRate);
}
BENCHMARK(BM_March)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace burin
