// What no drawing can do without: reading the file and building the tree of rays. The table of the
// whole command (tests/bench/table.sh) divides by it.
#include <burin/converters/mesh_reader.h>
#include <burin/visibility/occluder.h>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace burin {
namespace {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void read_and_tree(benchmark::State& state, const std::filesystem::path& path) {
  RunContext context;
  const auto surface =
      read_mesh(path, context).parts.front().form->realise({.curvature = false}, context);
  const ProxyMesh* const proxies[] = {&surface->proxy()};
  double read = 0, tree = 0;
  for (auto _ : state) {
    const double r = seconds([&] { benchmark::DoNotOptimize(read_mesh(path, context)); });
    const double t = seconds([&] { benchmark::DoNotOptimize(Occluder(proxies, context)); });
    read += r;
    tree += t;
    state.SetIterationTime(r + t);
  }
  state.counters["read"] = benchmark::Counter(read, benchmark::Counter::kAvgIterations);
  state.counters["tree"] = benchmark::Counter(tree, benchmark::Counter::kAvgIterations);
}

// The meshes of the folder BURIN_BENCH_MESHES, as table.sh writes them; none where it is not set.
const bool kRegistered = [] {
  const char* folder = std::getenv("BURIN_BENCH_MESHES");
  if (folder == nullptr) return false;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = "baseline/" + entry.path().stem().string();
    benchmark::RegisterBenchmark(name.c_str(), read_and_tree, entry.path())
        ->UseManualTime()
        ->Iterations(3);
  }
  return true;
}();

}  // namespace
}  // namespace burin
