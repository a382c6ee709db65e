#include <burin/base/error.h>
#include <burin/drawing/outline.h>
#include <burin/drawing/pen_order.h>
#include <burin/drawing/writers.h>

#include <benchmark/benchmark.h>
#include <burin_test/drawings.h>

#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <sstream>
#include <streambuf>
#include <thread>

namespace {

using namespace burin;

/// Counts what is written.
class Sink : public std::streambuf {
 public:
  std::streamsize bytes = 0;

 protected:
  std::streamsize xsputn(const char*, std::streamsize n) override {
    bytes += n;
    return n;
  }
  int overflow(int c) override {
    ++bytes;
    return c;
  }
};

/// An engraving: strokes of 100 points with varying width.
Drawing engraving(int strokes) {
  Drawing d = test::sample_drawing();
  d.layers.resize(1);
  d.layers[0].paths.clear();
  for (int i = 0; i < strokes; ++i) {
    d.layers[0].paths.push_back(
        test::wavy_stroke({10 + 0.01 * (i % 97), 0.03 * i}, 25 + 0.5 * (i % 61), 0.02 * (i % 53)));
  }
  return d;
}

void BM_WriteSvg(benchmark::State& state) {
  const Drawing d = engraving(static_cast<int>(state.range(0)));
  Sink sink;
  for (auto _ : state) {
    sink.bytes = 0;
    std::ostream out(&sink);
    write_svg(d, {}, out, RunContext());
  }
  state.counters["MB"] = static_cast<double>(sink.bytes) / 1e6;
}
BENCHMARK(BM_WriteSvg)->Arg(5000)->Unit(benchmark::kMillisecond)->UseRealTime();

void BM_WriteJson(benchmark::State& state) {
  const Drawing d = engraving(static_cast<int>(state.range(0)));
  Sink sink;
  for (auto _ : state) {
    sink.bytes = 0;
    std::ostream out(&sink);
    write_json(d, {}, out, RunContext());
  }
  state.counters["MB"] = static_cast<double>(sink.bytes) / 1e6;
}
BENCHMARK(BM_WriteJson)->Arg(5000)->Arg(10000)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Short lines all over a sheet of A2.
std::vector<std::array<Vec2, 2>> short_lines(std::int64_t count) {
  std::mt19937 random(1);
  const auto any = [&](double size) { return size * static_cast<double>(random()) / 4294967296.0; };
  std::vector<std::array<Vec2, 2>> lines(static_cast<std::size_t>(count));
  for (auto& line : lines) {
    line[0] = {any(594), any(420)};
    line[1] = line[0] + Vec2(any(8) - 4, any(8) - 4);
  }
  return lines;
}

std::vector<PenPath> pen_paths(const std::vector<std::array<Vec2, 2>>& lines) {
  std::vector<PenPath> paths;
  for (const auto& line : lines) paths.push_back({line, false, 0, 0});
  return paths;
}

/// `way`: of the travel, how much is left; `random`: mean distance to the next over sqrt(area /
/// lines), 0.7124 for the shortest tour of places.
void BM_PenOrder(benchmark::State& state) {
  const auto lines = short_lines(state.range(0));
  const std::vector<PenPath> paths = pen_paths(lines);
  const RunContext context;
  double travel = 0;
  for (auto _ : state) travel = pen_order(paths, {}, context).travel;
  state.counters["way"] = travel / given_order(paths, Vec2(0), context).travel;
  state.counters["random"] = travel / std::sqrt(594.0 * 420 * static_cast<double>(lines.size()));
}
BENCHMARK(BM_PenOrder)
    ->Arg(1000)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

/// The longest time from a cancel to the end of an order of a million lines.
void BM_PenOrderCancelled(benchmark::State& state) {
  const auto lines = short_lines(1'000'000);
  const std::vector<PenPath> paths = pen_paths(lines);
  using Clock = std::chrono::steady_clock;
  double longest = 0;
  for (auto _ : state) {
    for (const int after : {50, 300, 700, 1500, 3000, 6000, 12'000}) {
      RunContext context;
      Clock::time_point asked{};
      std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(after));
        asked = Clock::now();
        context.cancel();
      });
      bool ended = false;
      try {
        pen_order(paths, {}, context);
      } catch (const Cancelled&) {
        ended = true;
      }
      const auto end = Clock::now();
      other.join();
      if (ended) longest = std::max(longest, std::chrono::duration<double>(end - asked).count());
    }
  }
  state.counters["ms"] = 1000 * longest;
}
BENCHMARK(BM_PenOrderCancelled)->Iterations(1)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
