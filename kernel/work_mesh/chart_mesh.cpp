#include <burin/base/groups.h>
#include <burin/work_mesh/chart_mesh.h>

#include <array>
#include <cstddef>
#include <utility>

namespace burin {

namespace {

std::uint32_t origin_of(const ChartMesh& mesh, std::size_t h) {
  return mesh.triangles[h / 3][h % 3];
}
std::uint32_t target_of(const ChartMesh& mesh, std::size_t h) {
  return mesh.triangles[h / 3][(h + 1) % 3];
}

/// Whether `h` and `o` may be both sides of one edge, their ends apart.
bool fit(const ChartMesh& mesh, std::size_t h, std::size_t o, bool one_model_edge) {
  const std::int32_t a = mesh.border[h], b = mesh.border[o];
  if (a < 0 || b < 0) return a < 0 && b < 0 && mesh.face[h / 3] == mesh.face[o / 3];
  return !one_model_edge || mesh.borders[static_cast<std::size_t>(a)].edge ==
                                mesh.borders[static_cast<std::size_t>(b)].edge;
}

/// The half-edges at each vertex, every edge at that end where fewer edges meet, so that no fan is
/// searched as a whole.
Groups<std::uint32_t> edges_at_vertices(const ChartMesh& mesh) {
  const std::size_t n = 3 * mesh.triangles.size();
  std::vector<std::uint32_t> degree(mesh.positions.size(), 0);
  for (std::size_t h = 0; h < n; ++h) ++degree[origin_of(mesh, h)];
  const auto home = [&](std::size_t h) {
    const std::uint32_t a = origin_of(mesh, h), b = target_of(mesh, h);
    return std::array{degree[a] < degree[b] || (degree[a] == degree[b] && a < b) ? a : b};
  };
  return grouped(mesh.positions.size(), n, home,
                 [](std::size_t h) { return std::array{static_cast<std::uint32_t>(h)}; });
}

}  // namespace

std::vector<HalfEdge> chart_mesh_opposites(const ChartMesh& mesh) {
  constexpr HalfEdge kAmbiguous = -2;
  std::vector<HalfEdge> opposite(3 * mesh.triangles.size(), kNoHalfEdge);
  const auto edges = edges_at_vertices(mesh);
  const auto opposed = [&](std::size_t h, std::size_t o) {
    return origin_of(mesh, h) == target_of(mesh, o) && target_of(mesh, h) == origin_of(mesh, o) &&
           h / 3 != o / 3;
  };
  // Two uses of one model edge; what is left over, of whichever edges.
  for (const bool one_model_edge : {true, false}) {
    const std::vector<HalfEdge> known = opposite;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      const auto here = edges[v];
      for (std::size_t i = 0; i < here.size(); ++i) {
        const std::size_t h = here[i];
        if (known[h] != kNoHalfEdge) continue;
        for (std::size_t j = i + 1; j < here.size(); ++j) {
          const std::size_t o = here[j];
          if (known[o] != kNoHalfEdge || !opposed(h, o) || !fit(mesh, h, o, one_model_edge)) {
            continue;
          }
          for (const auto& [from, to] : {std::pair(h, o), std::pair(o, h)}) {
            opposite[from] = opposite[from] == kNoHalfEdge ? static_cast<HalfEdge>(to) : kAmbiguous;
          }
        }
      }
    }
  }
  for (std::size_t h = 0; h < opposite.size(); ++h) {
    const HalfEdge o = opposite[h];
    if (o == kAmbiguous || (o >= 0 && opposite[static_cast<std::size_t>(o)] < 0)) {
      opposite[h] = kNoHalfEdge;
    }
  }
  return opposite;
}

}  // namespace burin
