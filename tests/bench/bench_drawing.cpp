#include <burin/drawing/outline.h>
#include <burin/drawing/writers.h>

#include <benchmark/benchmark.h>
#include <burin_test/drawings.h>

#include <sstream>
#include <streambuf>

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

}  // namespace
