/// Volumes: values, derivatives, prefilter, and the surface of a noisy ball in 256 x 256 x 128
/// samples.

#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/implicit/volume_function.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

namespace burin {
namespace {

// A bumpy ball with noise of a fiftieth of its step, in whole numbers of 16 bits.
VolumeGrid ball(std::array<std::int32_t, 3> size) {
  VolumeGrid g;
  g.size = size;
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 200);
  const Vec3 middle = 0.5 * Vec3(size[0], size[1], size[2]);
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const Vec3 p = (Vec3(i, j, k) - middle) / middle;
        const double bumps = 0.05 * std::sin(9 * p.x) * std::sin(11 * p.y) * std::sin(10 * p.z);
        const double depth = 0.8 + bumps - glm::length(p);
        const double value = 20'000 + 10'000 * std::tanh(20 * depth) + noise(random);
        g.samples.push_back(static_cast<float>(std::round(value)));
      }
    }
  }
  return g;
}

std::shared_ptr<const ImplicitFunction> ball_function(std::int32_t degree) {
  return make_volume_function(ball({128, 128, 128}), {.level = 20'000, .degree = degree},
                              RunContext());
}

std::vector<Vec3> points_in_volume(std::size_t n) {
  std::vector<Vec3> out(n);
  // As a block of the mesher has them: neighbours share most coefficients.
  for (std::size_t i = 0; i < n; ++i) {
    out[i] = {20 + 0.7 * static_cast<double>(i % 27), 30 + 0.7 * static_cast<double>(i / 27 % 27),
              40 + 0.7 * std::floor(static_cast<double>(i) / 729)};
  }
  return out;
}

void volume_values(benchmark::State& state) {
  const auto f = ball_function(static_cast<std::int32_t>(state.range(0)));
  const auto p = points_in_volume(20'000);
  std::vector<double> out(p.size());
  for (auto _ : state) {
    f->values(p, out);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.size()));
}
BENCHMARK(volume_values)->Arg(3)->Arg(2);

void volume_gradients(benchmark::State& state) {
  const auto f = ball_function(3);
  const auto p = points_in_volume(20'000);
  std::vector<Gradient1> out(p.size());
  for (auto _ : state) {
    f->gradients(p, out);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.size()));
}
BENCHMARK(volume_gradients);

void volume_hessians(benchmark::State& state) {
  const auto f = ball_function(3);
  const auto p = points_in_volume(20'000);
  std::vector<Gradient2> out(p.size());
  for (auto _ : state) {
    f->hessians(p, out);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(p.size()));
}
BENCHMARK(volume_hessians);

/// 8.4 million samples smoothed and prefiltered.
void volume_prepare(benchmark::State& state) {
  const VolumeGrid g = ball({256, 256, 128});
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_volume_function(
        g, {.level = 20'000, .interpolate = true, .smoothing = 1}, RunContext()));
  }
}
BENCHMARK(volume_prepare)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void volume_survey(benchmark::State& state) {
  const auto f =
      make_volume_function(ball({256, 256, 128}), {.level = 20'000, .smoothing = 1}, RunContext());
  RunContext context;
  for (auto _ : state) {
    benchmark::DoNotOptimize(ImplicitForm(f, std::nullopt, context, kSmallestVolumePart));
  }
}
BENCHMARK(volume_survey)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

void volume_realise(benchmark::State& state) {
  RunContext context;
  const ImplicitForm form(
      make_volume_function(ball({256, 256, 128}), {.level = 20'000, .smoothing = 1}, RunContext()),
      std::nullopt, context, kSmallestVolumePart);
  RealiseOptions options;
  options.tolerance = 0.05;
  double triangles = 0;
  for (auto _ : state) {
    triangles = static_cast<double>(form.realise(options, context)->proxy().mesh.triangles.size());
  }
  state.counters["triangles"] = triangles;
}
BENCHMARK(volume_realise)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace
}  // namespace burin
