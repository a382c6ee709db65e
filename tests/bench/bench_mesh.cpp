#include <burin/mesh/curvature.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/mesh/reorder.h>

#include <benchmark/benchmark.h>
#include <burin_test/irregular.h>

#include <map>
#include <numeric>

namespace burin {
namespace {

const TriMesh& torus_mesh(double triangles) {
  static std::map<double, TriMesh> cache;
  const auto it = cache.find(triangles);
  if (it != cache.end()) return it->second;
  return cache[triangles] = test::irregular_torus(10, 4, triangles);
}

void count(benchmark::State& state, const TriMesh& mesh) {
  state.counters["triangles/s"] = benchmark::Counter(static_cast<double>(mesh.triangles.size()),
                                                     benchmark::Counter::kIsIterationInvariantRate);
}

void topology(benchmark::State& state) {
  const TriMesh& mesh = torus_mesh(static_cast<double>(state.range(0)));
  const RunContext context;
  for (auto _ : state) benchmark::DoNotOptimize(build_topology(mesh, context));
  count(state, mesh);
}

void proxy(benchmark::State& state) {
  const TriMesh& mesh = torus_mesh(static_cast<double>(state.range(0)));
  const RunContext context;
  for (auto _ : state) {
    state.PauseTiming();
    TriMesh copy = mesh;
    state.ResumeTiming();
    benchmark::DoNotOptimize(build_proxy(std::move(copy), {}, context));
  }
  count(state, mesh);
}

void curvature(benchmark::State& state) {
  const RunContext context;
  const ProxyMesh mesh = build_proxy(torus_mesh(static_cast<double>(state.range(0))), {}, context);
  for (auto _ : state) benchmark::DoNotOptimize(estimate_curvature(mesh, {}, context));
  count(state, mesh.mesh);
}

void curvature_of_noise(benchmark::State& state) {
  const RunContext context;
  const ProxyMesh mesh =
      build_proxy(test::noisy(torus_mesh(static_cast<double>(state.range(0))), 0.05), {}, context);
  for (auto _ : state) benchmark::DoNotOptimize(estimate_curvature(mesh, {}, context));
  count(state, mesh.mesh);
}

void reorder_scattered(benchmark::State& state) {
  const TriMesh& mesh = torus_mesh(static_cast<double>(state.range(0)));
  TriMesh scattered = mesh;
  const std::size_t n = mesh.positions.size();
  std::size_t step = n * 7 / 11 | 1;
  while (std::gcd(step, n) != 1) step += 2;
  std::vector<std::uint32_t> renamed(n);
  for (std::size_t i = 0; i < n; ++i) {
    renamed[i] = static_cast<std::uint32_t>(i * step % n);
    scattered.positions[renamed[i]] = mesh.positions[i];
  }
  for (Triangle& t : scattered.triangles) t = {renamed[t[0]], renamed[t[1]], renamed[t[2]]};
  for (auto _ : state) {
    state.PauseTiming();
    TriMesh copy = scattered;
    state.ResumeTiming();
    benchmark::DoNotOptimize(reorder_for_cache(copy));
  }
  count(state, mesh);
}

#define BURIN_BENCH_MESH(name)        \
  BENCHMARK(name)                     \
      ->Arg(100000)                   \
      ->Arg(1000000)                  \
      ->Unit(benchmark::kMillisecond) \
      ->MeasureProcessCPUTime()       \
      ->UseRealTime()
BURIN_BENCH_MESH(topology);
BURIN_BENCH_MESH(proxy);
BURIN_BENCH_MESH(curvature);
BURIN_BENCH_MESH(curvature_of_noise);
BURIN_BENCH_MESH(reorder_scattered);
#undef BURIN_BENCH_MESH

}  // namespace
}  // namespace burin
