/// Callouts of a hundred items on an A3 sheet: anchors from the raster, then their places.

#include <burin/annotate/annotate.h>
#include <burin/annotate/place.h>

#include <benchmark/benchmark.h>

#include <cmath>

namespace burin {
namespace {

constexpr int kAcross = 10;
constexpr Vec2 kSheet(420, 297);

/// Discs on a grid, a part each.
std::int32_t part_at(Vec2 p) {
  const Vec2 cell((p.x - 60) / 30, (p.y - 40) / 21);
  if (cell.x < 0 || cell.y < 0 || cell.x >= kAcross || cell.y >= kAcross) return -1;
  const Vec2 in = glm::fract(cell) - 0.5;
  const auto x = static_cast<std::int32_t>(cell.x), y = static_cast<std::int32_t>(cell.y);
  return glm::length(in) < 0.4 ? y * kAcross + x : -1;
}

void annotate_100_items(benchmark::State& state) {
  Annotations annotations;
  annotations.callouts = true;
  for (int i = 0; i < kAcross * kAcross; ++i) annotations.items.push_back({i + 1, "part", {i}});
  const LabelMap seen = make_label_map({{0, 0}, kSheet}, part_at, RunContext());
  for (auto _ : state) {
    Drawing drawing;
    drawing.paper_width = kSheet.x, drawing.paper_height = kSheet.y;
    Path border;
    border.points = {{60, 40}, {360, 40}, {360, 250}, {60, 250}};
    border.closed = true;
    drawing.layers.push_back({"outline", {border}});
    annotate(drawing, seen, {}, annotations, {.height = 3.5}, RunContext());
    benchmark::DoNotOptimize(drawing.layers.size());
  }
}
BENCHMARK(annotate_100_items)->Unit(benchmark::kMillisecond);

void label_map_of_a3(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(make_label_map({{0, 0}, kSheet}, part_at, RunContext()).parts.data());
  }
}
BENCHMARK(label_map_of_a3)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace burin
