/// Implicit functions: values, derivatives, proxies and marching of a blend of three cylinders.

#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace burin {
namespace {

using namespace implicit;

Expression blend() {
  const Expression c = cylinder(1, 6);
  return smooth_unite(smooth_unite(c, rotate(c, {90, 0, 0}), 0.5), rotate(c, {0, 90, 0}), 0.5);
}

std::vector<Vec3> points(std::size_t n) {
  std::vector<Vec3> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto k = static_cast<double>(i);
    out[i] = {3 * std::sin(1.1 * k), 3 * std::sin(1.7 * k + 1), 3 * std::sin(2.3 * k + 2)};
  }
  return out;
}

void implicit_values(benchmark::State& state) {
  const auto f = make_function(blend());
  const auto p = points(10'000);
  std::vector<double> out(p.size());
  for (auto _ : state) {
    f->values(p, out);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.size()));
}
BENCHMARK(implicit_values);

void implicit_gradients(benchmark::State& state) {
  const auto f = make_function(blend());
  const auto p = points(10'000);
  std::vector<Gradient1> out(p.size());
  for (auto _ : state) {
    f->gradients(p, out);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.size()));
}
BENCHMARK(implicit_gradients);

void implicit_hessians(benchmark::State& state) {
  const auto f = make_function(blend());
  const auto p = points(10'000);
  std::vector<Gradient2> out(p.size());
  for (auto _ : state) {
    f->hessians(p, out);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.size()));
}
BENCHMARK(implicit_hessians);

void implicit_one_hessian(benchmark::State& state) {
  const auto f = make_function(blend());
  const auto p = points(1'000);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(f->hessian(p[i]));
    i = (i + 1) % p.size();
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(implicit_one_hessian);

/// The first look over the domain.
void implicit_survey(benchmark::State& state) {
  const auto f = make_function(blend());
  RunContext context;
  for (auto _ : state) benchmark::DoNotOptimize(ImplicitForm(f, std::nullopt, context));
}
BENCHMARK(implicit_survey)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();

/// The proxy of a torus (360,000 triangles) and of the blend (60,000), creases and all.
void implicit_realise(benchmark::State& state) {
  const bool smooth = state.range(0) == 0;
  RunContext context;
  const ImplicitForm form(make_function(smooth ? torus(3, 1) : blend()), std::nullopt, context);
  RealiseOptions options;
  options.tolerance = smooth ? 0.00018 : 0.0015;
  double triangles = 0;
  for (auto _ : state) {
    triangles = static_cast<double>(form.realise(options, context)->proxy().mesh.triangles.size());
  }
  state.counters["triangles"] = triangles;
}
BENCHMARK(implicit_realise)
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// Both meshers at one tolerance, nets (0) and Delaunay (1): a torus, with 100,000 triangles of the
/// latter; the blend; a fillet of 0.5 mm on a part of 100 mm.
void implicit_meshers(benchmark::State& state) {
  const Expression plate =
      smooth_unite(box(100, 100, 10), translate(cylinder(10, 60), {0, 0, 27}), 0.5);
  const std::pair<Expression, double> cases[] = {
      {torus(3, 1), 0.00078}, {blend(), 0.0015}, {plate, 0.005}};
  const auto& [shape, tolerance] = cases[state.range(0)];
  RunContext context;
  const ImplicitForm form(make_function(shape), std::nullopt, context, 0,
                          {state.range(1) == 0 ? Mesher::Nets : Mesher::Delaunay});
  RealiseOptions options;
  options.tolerance = tolerance;
  std::shared_ptr<const Surface> surface;
  for (auto _ : state) surface = form.realise(options, context);
  const ProxyMesh& proxy = surface->proxy();
  double least = 2;
  for (const Triangle& t : proxy.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = proxy.mesh.positions[t[k]],
                 u = glm::normalize(proxy.mesh.positions[t[(k + 1) % 3]] - p),
                 v = glm::normalize(proxy.mesh.positions[t[(k + 2) % 3]] - p);
      least = std::min(least, std::acos(std::min(1.0, glm::dot(u, v))));
    }
  }
  state.counters["triangles"] = static_cast<double>(proxy.mesh.triangles.size());
  state.counters["degrees"] = least * 57.29577951308232;
  state.counters["deviation"] = proxy.tolerance / tolerance;
}
BENCHMARK(implicit_meshers)
    ->ArgsProduct({{0, 1, 2}, {0, 1}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// Steps of a fiftieth of the fillet's radius along lines of the blend.
void implicit_march(benchmark::State& state) {
  RunContext context;
  const ImplicitForm form(make_function(blend()), std::nullopt, context);
  const auto surface = form.realise({.tolerance = 0.005}, context);
  const auto starts = surface->cover({.count = 100}, context);
  std::size_t i = 0;
  std::int64_t steps = 0;
  for (auto _ : state) {
    MarchStep step;
    step.end = starts[i++ % starts.size()];
    step.direction = surface->frame(step.end).d1;
    for (int k = 0; k < 50 && step.stop == MarchStop::Completed; ++k, ++steps) {
      step = surface->march(step.end, step.direction, 0.01);
    }
  }
  state.SetItemsProcessed(steps);
}
BENCHMARK(implicit_march)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace burin
