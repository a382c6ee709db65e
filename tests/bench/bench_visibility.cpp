/// The occluder and the visible spans of features and strokes, for tori of 100,000 and 1,000,000
/// triangles.

#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/visibility/occluder.h>

#include <benchmark/benchmark.h>
#include <burin_test/shapes.h>
#include <burin_test/view.h>

#include <cmath>
#include <limits>

namespace burin {
namespace {

ProxyMesh bare_torus(std::int64_t triangles) {
  const auto n = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4));
  ProxyMesh proxy;
  proxy.mesh = test::torus(3, 1, 2 * n, n);
  return proxy;
}

void build_occluder(benchmark::State& state) {
  const ProxyMesh proxy = bare_torus(state.range(0));
  const ProxyMesh* pointer = &proxy;
  const RunContext context;
  const ThreadLimit limit(static_cast<int>(state.range(1)));
  for (auto _ : state) {
    const Occluder occluder(std::span(&pointer, 1), context);
    benchmark::DoNotOptimize(occluder.diagonal());
  }
}
BENCHMARK(build_occluder)
    ->ArgsProduct({{100'000, 1'000'000}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

void cast_rays(benchmark::State& state) {
  const ProxyMesh proxy = bare_torus(state.range(0));
  const ProxyMesh* pointer = &proxy;
  const RunContext context;
  const Occluder occluder(std::span(&pointer, 1), context);
  const Vec3 to_viewer = glm::normalize(Vec3(1, -1, 1));
  const Rng rng(1);
  std::uint64_t i = 0;
  for (auto _ : state) {
    const double u = 2 * test::kPi * rng.uniform(2 * i), v = 2 * test::kPi * rng.uniform(2 * i + 1);
    const Vec3 n{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
    const Vec3 axis{3 * std::cos(u), 3 * std::sin(u), 0};
    benchmark::DoNotOptimize(
        occluder.occluded(axis + n * 1.001, to_viewer, 0, std::numeric_limits<double>::infinity()));
    ++i;
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(cast_rays)->Arg(100'000)->Arg(1'000'000);

// `count` strokes of 100 points each around the tube of the torus of `bare_torus`, as a tracer
// would leave them: on the triangles, with normals and triangles.
std::vector<Curve3> torus_strokes(std::int64_t triangles, int count) {
  const auto n = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4));
  const Rng rng(2);
  std::vector<Curve3> strokes(static_cast<std::size_t>(count));
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    const double u = 2 * test::kPi * rng.uniform(2 * s),
                 v0 = 2 * test::kPi * rng.uniform(2 * s + 1);
    strokes[s].source.part = 0;
    for (int i = 0; i < 100; ++i) {
      const double v = v0 + 1.5 * i / 100;
      const Vec3 out{std::cos(u), std::sin(u), 0};
      strokes[s].normals.push_back(out * std::cos(v) + Vec3(0, 0, std::sin(v)));
      strokes[s].points.push_back(3.0 * out + strokes[s].normals.back());
      const double turn = v / (2 * test::kPi);
      const auto row = static_cast<std::int32_t>(u / (2 * test::kPi) * 2 * n);
      const auto column = static_cast<std::int32_t>((turn - std::floor(turn)) * n);
      if (i < 99) strokes[s].faces.push_back(2 * (row * static_cast<std::int32_t>(n) + column));
    }
  }
  return strokes;
}

test::View torus_view(std::int64_t triangles) {
  return test::View({bare_torus(triangles).mesh}, {});
}

void map_features(benchmark::State& state) {
  const test::View view = torus_view(state.range(0));
  for (auto _ : state) {
    const VisibilityMap map(*view.occluder, view.pointers, view.camera, view.features,
                            view.context);
    benchmark::DoNotOptimize(map.classify(view.features, {.classify_outer = true}, view.context));
  }
  state.counters["segments"] = static_cast<double>(view.features[0].segment_count());
}
BENCHMARK(map_features)->Arg(100'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond)->UseRealTime();

void classify_strokes(benchmark::State& state) {
  const test::View view = torus_view(state.range(0));
  const auto strokes = torus_strokes(state.range(0), static_cast<int>(state.range(1)));
  for (auto _ : state) {
    benchmark::DoNotOptimize(view.map->classify(strokes, {}, view.context));
  }
}
BENCHMARK(classify_strokes)
    ->Args({100'000, 5'000})
    ->Args({1'000'000, 20'000})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace burin
