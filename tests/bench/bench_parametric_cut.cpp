// Cutting proxies along the contours of a view. Budget: a few ms for a part of 10,000 triangles.

#include <benchmark/benchmark.h>
#include <burin_test/atlases.h>

#include <cmath>

namespace burin {
namespace {

Camera camera_of(const ChartMesh& mesh) {
  return Camera::fit(
      [&](const Mat3& axes) {
        Box3 box;
        for (const Vec3& p : mesh.positions) box.add(axes * p);
        return box;
      },
      {.direction = {0.3, -1, 0.5}});
}

void cut(benchmark::State& state, const test::Charted& shape) {
  const Camera camera = camera_of(shape.mesh);
  const RunContext context;
  std::size_t triangles = 0;
  for (auto _ : state) {
    state.PauseTiming();
    ChartMesh mesh = shape.mesh;
    state.ResumeTiming();
    cut_along_contours(mesh, AtlasSampler(shape.atlas), camera, {}, context);
    triangles = mesh.triangles.size();
  }
  state.counters["before"] = static_cast<double>(shape.mesh.triangles.size());
  state.counters["after"] = static_cast<double>(triangles);
}

int side(std::int64_t triangles) {
  return static_cast<int>(std::sqrt(static_cast<double>(triangles) / 4));
}

void parametric_cut_torus(benchmark::State& state) {
  const int n = side(state.range(0));
  cut(state, test::charted_torus(3, 1, 2 * n, n));
}
BENCHMARK(parametric_cut_torus)
    ->Arg(1000)
    ->Arg(10000)
    ->Arg(50000)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void parametric_cut_waves(benchmark::State& state) {
  const auto graph = [](Vec2 p) {
    SurfaceDerivatives d;
    const double s = std::sin(1.3 * p.x), c = std::cos(1.3 * p.x), t = std::sin(1.1 * p.y),
                 k = std::cos(1.1 * p.y), a = 0.5;
    d.p = {p, a * s * k};
    d.u = {1, 0, a * 1.3 * c * k};
    d.v = {0, 1, -a * 1.1 * s * t};
    d.uu = {0, 0, -a * 1.69 * s * k};
    d.uv = {0, 0, -a * 1.43 * c * t};
    d.vv = {0, 0, -a * 1.21 * s * k};
    return d;
  };
  test::AtlasBuilder b;
  const int face = b.add_face(test::chart_of(graph, Vec2(-6), Vec2(6)));
  const int n = static_cast<int>(std::sqrt(static_cast<double>(state.range(0)) / 2));
  b.add_grid(face, {Vec2(-6), Vec2(6)}, n, n, {-1, -1, -1, -1});
  cut(state, test::Charted(std::move(b)));
}
BENCHMARK(parametric_cut_waves)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

void parametric_wedge_normals(benchmark::State& state) {
  const int n = side(state.range(0));
  test::Charted shape = test::charted_torus(3, 1, 2 * n, n);
  const RunContext context;
  for (auto _ : state) set_wedge_normals(shape.mesh, shape.atlas, context);
}
BENCHMARK(parametric_wedge_normals)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace burin
