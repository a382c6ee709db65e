// Exact forms: what a stroke asks of a charted surface, and the time to make one. Budgets: a march
// of a stroke's step 1 us, a frame 0.2 us, the teapot's triangles with cuts 0.1 s on one core.

#include <burin/forms/patches/parametric_form.h>

#include <benchmark/benchmark.h>
#include <burin_test/charts.h>
#include <burin_test/horn.h>
#include <burin_test/nurbs_shapes.h>

namespace burin {
namespace {

using Patches = std::vector<std::shared_ptr<const Chart>>;

Patches shape(std::int64_t which) {
  switch (which) {
    case 0:
      return {test::torus_chart(3, 1)};
    case 1:
      return {make_nurbs_chart(test::torus_nurbs(3, 1))};
    case 2:
      return {make_nurbs_chart(test::horn_nurbs())};
    default:
      return test::six_patches({3, 2, 1});
  }
}

std::shared_ptr<const Surface> realised(std::int64_t which, double& size) {
  const ParametricForm form(shape(which));
  size = form.bounds(Mat3(1)).diagonal();
  RunContext context;
  return form.realise({.tolerance = 2e-4 * size}, context);
}

// Lines of many short steps: 0.4 paper mm on a drawing of 200 mm, or the share given in 1e-4.
void march(benchmark::State& state) {
  double size = 1;
  const auto surface = realised(state.range(0), size);
  const RunContext context;
  const auto points = surface->cover({.count = 500}, context);
  const double length = 1e-4 * static_cast<double>(state.range(1)) * size;
  std::int64_t steps = 0;
  for (auto _ : state) {
    for (const SurfacePoint& p : points) {
      MarchStep step;
      step.end = p;
      step.direction = surface->frame(p).d1;
      for (int k = 0; k < 50 && step.stop == MarchStop::Completed; ++k, ++steps) {
        step = surface->march(step.end, step.direction, length);
      }
      benchmark::DoNotOptimize(step.length);
    }
  }
  state.SetItemsProcessed(steps);
}
BENCHMARK(march)->ArgsProduct({{0, 1, 2, 3}, {10, 20, 200}});

void frame(benchmark::State& state) {
  double size = 1;
  const auto surface = realised(state.range(0), size);
  const RunContext context;
  const auto points = surface->cover({.count = 1000}, context);
  for (auto _ : state) {
    for (const SurfacePoint& p : points) benchmark::DoNotOptimize(surface->frame(p).k1);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(frame)->DenseRange(0, 3);

void realise(benchmark::State& state) {
  const ParametricForm form(shape(state.range(0)));
  const Camera camera = Camera::fit([&](const Mat3& a) { return form.bounds(a); }, {});
  RunContext context;
  std::size_t triangles = 0;
  for (auto _ : state) {
    const auto surface =
        form.realise({.tolerance = 0.05 / camera.scale(), .view = &camera}, context);
    triangles = surface->proxy().wedges.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(realise)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace burin
