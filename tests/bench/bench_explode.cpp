/// Contacts, steps and trails of an assembly of 100 parts: a plate with 33 stacks of a bush, a
/// washer and a bolt.

#include <burin/base/parallel.h>
#include <burin/explode/explode.h>
#include <burin/forms/mesh/mesh_form.h>

#include <benchmark/benchmark.h>
#include <burin_test/exploded.h>

#include <vector>

namespace burin {
namespace {

void explode_100_parts(benchmark::State& state) {
  const Scene scene = test::stacks(33);
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    RunContext context;
    Diagnostics diagnostics;
    const ExplodeModel model(scene, std::vector<bool>(scene.parts.size(), true), context);
    const Explosion explosion = model.find({}, diagnostics, context);
    benchmark::DoNotOptimize(model.trails(explosion.steps, 1).size());
  }
}
BENCHMARK(explode_100_parts)
    ->Arg(1)
    ->Arg(2)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace burin
