/// Building the occluder and asking it, for tori of 100,000 and 1,000,000 triangles.

#include <burin/base/parallel.h>
#include <burin/base/rng.h>
#include <burin/visibility/occluder.h>

#include <benchmark/benchmark.h>
#include <burin_test/shapes.h>

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

}  // namespace
}  // namespace burin
