/// Callouts of a hundred items on an A3 sheet: anchors, then their places.

#include <burin/annotate/annotate.h>
#include <burin/annotate/place.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace burin {
namespace {

constexpr int kAcross = 10;
constexpr Vec2 kSheet(420, 297);

/// Discs on a grid, a part each, of as many sides as the border of a round part has.
std::vector<Area> discs() {
  constexpr int kSides = 100;
  std::vector<Area> areas;
  for (int i = 0; i < kAcross * kAcross; ++i) {
    const int column = i % kAcross, row = i / kAcross;
    const Vec2 middle(60 + 30 * (column + 0.5), 40 + 21 * (row + 0.5));
    std::vector<Vec2> ring;
    for (int k = 0; k < kSides; ++k) {
      const double u = 2 * std::numbers::pi * k / kSides;
      ring.push_back(middle + Vec2(12 * std::cos(u), 8.4 * std::sin(u)));
    }
    areas.push_back({.part = i, .rings = {std::move(ring)}});
  }
  return areas;
}

void annotate_100_items(benchmark::State& state) {
  Annotations annotations;
  annotations.callouts = true;
  for (int i = 0; i < kAcross * kAcross; ++i) annotations.items.push_back({i + 1, "part", {i}});
  const std::vector<Area> seen = discs();
  for (auto _ : state) {
    Drawing drawing;
    drawing.paper_width = kSheet.x, drawing.paper_height = kSheet.y;
    Path border;
    border.points = {{60, 40}, {360, 40}, {360, 250}, {60, 250}};
    border.closed = true;
    drawing.layers.push_back({"outline", {border}});
    annotate(drawing, seen, annotations, {.height = 3.5}, RunContext());
    benchmark::DoNotOptimize(drawing.layers.size());
  }
}
BENCHMARK(annotate_100_items)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace burin
