// What no drawing can do without: reading the file and building the tree of rays. The table of the
// whole command (tests/bench/table.sh) divides by it.
#include <burin/converters/mesh_reader.h>
#include <burin/visibility/occluder.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <vector>

namespace burin {
namespace {

double seconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void read_and_tree(benchmark::State& state, const std::filesystem::path& path) {
  RunContext context;
  const auto surface =
      read_mesh(path, context).parts.front().form->realise({.curvature = false}, context);
  const ProxyMesh* const proxies[] = {&surface->proxy()};
  std::vector<double> read, tree;
  for (auto _ : state) {
    const double r = seconds([&] { benchmark::DoNotOptimize(read_mesh(path, context)); });
    const double t = seconds([&] { benchmark::DoNotOptimize(Occluder(proxies, context)); });
    read.push_back(r);
    tree.push_back(t);
    state.SetIterationTime(r + t);
  }
  state.counters["read"] = median(read);
  state.counters["tree"] = median(tree);
}

// The meshes of the folder BURIN_BENCH_MESHES, as table.sh writes them; none where it is not set.
const bool kRegistered = [] {
  const char* folder = std::getenv("BURIN_BENCH_MESHES");
  if (folder == nullptr) return false;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = "baseline/" + entry.path().stem().string();
    benchmark::RegisterBenchmark(name.c_str(), read_and_tree, entry.path())
        ->UseManualTime()
        ->Iterations(7);
  }
  return true;
}();

}  // namespace
}  // namespace burin
