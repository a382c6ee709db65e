// What a direction costs that comes from a plug-in, beside the same one built in: both follow the
// tangent part of one direction.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/field/catalogue.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>
#include <burin/plugin/plugins.h>

#include <benchmark/benchmark.h>
#include <burin_test/facets.h>
#include <burin_test/irregular.h>
#include <burin_test/shapes.h>

#include <cstdlib>
#include <memory>
#include <vector>

namespace burin {
namespace {

constexpr const char* kNames[] = {"fixed", "bench-fixed"};

void load() {
  static const plugin::Plugin once = plugin::load(BURIN_BENCH_PLUGIN);
  if (!once.refused.empty()) throw UsageError(once.refused);
}

/// The crosses at all triangles of a ball.
void direction(benchmark::State& state) {
  load();
  const auto surface = test::realised(test::icosphere(1, 64));
  const std::vector<const Surface*> surfaces{surface.get()};
  const Camera eye = Camera::fit(
      [](const Mat3& axes) {
        return Box3{axes * Vec3(-1), axes * Vec3(1)};
      },
      {});
  const RunContext context;
  const char* const name = kNames[state.range(0)];
  const field::FieldOptions options{.name = name};
  const Field field = field::find(name).make({.surfaces = surfaces,
                                              .camera = eye,
                                              .options = options,
                                              .context = context,
                                              .shown = {surfaces, {}}});
  std::vector<SurfacePoint> points;
  std::vector<Frame> frames;
  for (std::uint32_t t = 0; t < surface->proxy().mesh.triangles.size(); ++t) {
    points.push_back(surface->lift({t, Vec3(1.0 / 3)}));
    frames.push_back(surface->frame(points.back()));
  }
  state.SetLabel(name);
  for (auto _ : state) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      benchmark::DoNotOptimize(field.cross({0, points[i], frames[i]}));
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(points.size()));
}
BENCHMARK(direction)->Name("plugin/direction")->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);

/// A whole drawing of a ball in full tone, by one thread.
void drawing(benchmark::State& state) {
  load();
  Scene scene;
  scene.parts.push_back({"ball", "", std::make_shared<MeshForm>(test::icosphere(1, 64))});
  Style style = builtin_style("engraving");
  set_style_key(style, "hatch.field", kNames[state.range(0)]);
  const Camera eye = Camera::fit(
      [](const Mat3& axes) {
        return Box3{axes * Vec3(-1), axes * Vec3(1)};
      },
      {});
  state.SetLabel(kNames[state.range(0)]);
  const ThreadLimit one(1);
  for (auto _ : state) {
    RunContext context;
    benchmark::DoNotOptimize(illustrate(scene, eye, style, {}, context));
  }
}
BENCHMARK(drawing)
    ->Name("plugin/drawing")
    ->DenseRange(0, 1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// What each start of a program costs where there is no plug-in.
void none(benchmark::State& state) {
  ::setenv("XDG_DATA_HOME", "/nowhere", 1);
  ::unsetenv("BURIN_PLUGIN_PATH");
  for (auto _ : state) plugin::load_all(true);
  ::unsetenv("XDG_DATA_HOME");
}
BENCHMARK(none)->Name("plugin/none")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace burin
