/// Implicit functions: values, derivatives, proxies and marching of a blend of three cylinders.

#include <burin/forms/implicit/expression.h>

#include <benchmark/benchmark.h>

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

}  // namespace
}  // namespace burin
