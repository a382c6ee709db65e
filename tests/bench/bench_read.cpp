// Reading and repair of a torus of a million triangles in each format.
#include <burin/converters/mesh_reader.h>
#include <burin/repair/repair.h>

#include <benchmark/benchmark.h>
#include <burin_test/folder.h>
#include <burin_test/mesh_files.h>
#include <burin_test/shapes.h>

namespace burin {
namespace {

const TriMesh& million() {
  static const TriMesh mesh = test::torus(50, 20, 1000, 500);
  return mesh;
}

void read_file(benchmark::State& state, const std::string& name, const std::string& bytes) {
  const test::TempFile file(name, bytes);
  const RunContext context;
  for (auto _ : state) benchmark::DoNotOptimize(read_mesh_file(file.path(), context));
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size() * state.iterations()));
}

void read_stl_binary(benchmark::State& s) { read_file(s, "a.stl", test::stl_binary(million())); }
void read_stl_ascii(benchmark::State& s) { read_file(s, "a.stl", test::stl_ascii(million())); }
void read_obj(benchmark::State& s) { read_file(s, "a.obj", test::obj(million())); }
void read_off(benchmark::State& s) { read_file(s, "a.off", test::off(million())); }
void read_ply_ascii(benchmark::State& s) { read_file(s, "a.ply", test::ply_ascii(million())); }
void read_ply_binary(benchmark::State& s) { read_file(s, "a.ply", test::ply_binary(million())); }

PolygonSoup soup_of(const TriMesh& mesh) {
  PolygonSoup soup;
  soup.positions = mesh.positions;
  for (const Triangle& t : mesh.triangles) {
    soup.indices.insert(soup.indices.end(), t.begin(), t.end());
    soup.offsets.push_back(soup.indices.size());
  }
  return soup;
}

void repair_soup(benchmark::State& state, const PolygonSoup& soup) {
  const RunContext context;
  for (auto _ : state) {
    state.PauseTiming();
    PolygonSoup copy = soup;
    state.ResumeTiming();
    Diagnostics diagnostics;
    benchmark::DoNotOptimize(repair(std::move(copy), {}, diagnostics, context));
  }
}

void repair_clean(benchmark::State& state) { repair_soup(state, soup_of(million())); }

/// Unshared corners, every third triangle turned over, fins and duplicates.
void repair_broken(benchmark::State& state) {
  const TriMesh& mesh = million();
  PolygonSoup soup;
  const auto add = [&](const Triangle& t) {
    for (const std::uint32_t v : t) {
      soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
      soup.positions.push_back(mesh.positions[v]);
    }
    soup.offsets.push_back(soup.indices.size());
  };
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Triangle t = mesh.triangles[i];
    if (i % 3 == 0) std::swap(t[1], t[2]);
    add(t);
    if (i % 97 == 0) add(t);
    if (i % 1009 == 0) add({t[0], t[1], mesh.triangles[mesh.triangles.size() - 1 - i][2]});
  }
  repair_soup(state, soup);
}

BENCHMARK(read_stl_binary)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_stl_ascii)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_obj)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_off)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_ply_ascii)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_ply_binary)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(repair_clean)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(repair_broken)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace burin
