// Feature lines of large meshes. Budget: 0.15 s at a million triangles, 15 ms at 100,000, on 2
// cores.

#include <burin/feature/feature.h>

#include <benchmark/benchmark.h>
#include <burin_test/shapes.h>

#include <cmath>
#include <vector>

namespace burin {
namespace {

Camera camera_on_proxies(const std::vector<ProxyMesh>& proxies) {
  return Camera::fit(
      [&](const Mat3& axes) {
        Box3 box;
        for (const ProxyMesh& p : proxies) {
          for (const Vec3& q : p.mesh.positions) box.add(axes * q);
        }
        return box;
      },
      {.direction = {0.3, -1, 0.5}});
}

void run(benchmark::State& state, const std::vector<ProxyMesh>& proxies) {
  const Camera camera = camera_on_proxies(proxies);
  std::vector<const ProxyMesh*> pointers;
  std::size_t triangles = 0, chains = 0;
  for (const ProxyMesh& p : proxies) {
    pointers.push_back(&p);
    triangles += p.mesh.triangles.size();
  }
  const RunContext context;
  for (auto _ : state) {
    Diagnostics diagnostics;
    const auto curves = extract_features(pointers, camera, {}, diagnostics, context);
    chains = curves.size();
    benchmark::DoNotOptimize(curves.data());
  }
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["chains"] = static_cast<double>(chains);
}

std::uint32_t side_of_torus(std::int64_t triangles) {
  return static_cast<std::uint32_t>(std::sqrt(static_cast<double>(triangles) / 4));
}

void feature_torus(benchmark::State& state) {
  const RunContext context;
  const std::uint32_t n = side_of_torus(state.range(0));
  std::vector<ProxyMesh> proxies;
  proxies.push_back(build_proxy(test::torus(3, 1, 2 * n, n), {}, context));
  run(state, proxies);
}
BENCHMARK(feature_torus)->Arg(100000)->Arg(1000000)->Unit(benchmark::kMillisecond)->UseRealTime();

// Bumps of some degrees everywhere: many contours and, at the creases of its facets, many chains.
void feature_rough_torus(benchmark::State& state) {
  const RunContext context;
  const std::uint32_t n = side_of_torus(state.range(0));
  TriMesh mesh = test::torus(3, 1, 2 * n, n);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] *= 1 + 0.3 / n * std::sin(12.9898 * static_cast<double>(i));
  }
  std::vector<ProxyMesh> proxies;
  proxies.push_back(build_proxy(std::move(mesh), {}, context));
  run(state, proxies);
}
BENCHMARK(feature_rough_torus)
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// Two tori through each other, as two parts.
void feature_intersection(benchmark::State& state) {
  const RunContext context;
  const std::uint32_t n = side_of_torus(state.range(0) / 2);
  std::vector<ProxyMesh> proxies;
  proxies.push_back(build_proxy(test::torus(3, 1, 2 * n, n), {}, context));
  proxies.push_back(build_proxy(
      test::mapped(test::torus(3, 1, 2 * n, n), [](Vec3 p) { return Vec3(p.x + 2.5, p.z, p.y); }),
      {}, context));
  run(state, proxies);
}
BENCHMARK(feature_intersection)
    ->Arg(100000)
    ->Arg(1000000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace burin
