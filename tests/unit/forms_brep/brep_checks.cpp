#include "brep_checks.h"

#include <burin/base/error.h>
#include <burin/mesh/tri_mesh.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace burin::test {
namespace {

TriMesh triangles_of(const ChartMesh& m) { return {m.positions, m.triangles}; }

double distance(Vec3 a, Vec3 b) { return glm::length(a - b); }

}  // namespace

std::string defects(const BrepModel& model, const ChartMesh& mesh, double slack) {
  const double off = slack * model.size();
  const TriMesh tri = triangles_of(mesh);
  Topology topology;
  try {
    topology = build_topology(tri, RunContext());
  } catch (const Error& error) {
    return error.what();
  }
  for (std::size_t h = 0; h < mesh.uv.size(); ++h) {
    const std::int32_t face = mesh.face[h / 3];
    const std::size_t next = h - h % 3 + (h + 1) % 3;
    const Vec3 p = mesh.positions[tri.triangles[h / 3][h % 3]];
    const double d = distance(model.chart(face).position(mesh.uv[h]), p);
    if (!(d <= off)) return fmt::format("corner {} is {} off its chart", h, d);
    const std::int32_t opposite = topology.opposite[h];
    const bool border = mesh.border[h] >= 0;
    if (opposite < 0 && !border) return fmt::format("half-edge {} ends inside a face", h);
    if (opposite >= 0) {
      const auto o = static_cast<std::size_t>(opposite);
      if ((mesh.border[o] >= 0) != border) return fmt::format("half-edge {} borders one side", h);
      if (!border && mesh.face[o / 3] != face) return fmt::format("half-edge {} has no edge", h);
    }
    if (!border) continue;
    const ChartMesh::Border& b = mesh.borders[static_cast<std::size_t>(mesh.border[h])];
    if (b.coedge < 0) return fmt::format("half-edge {} knows no coedge", h);
    for (const auto& [t, corner] : {std::pair{b.t0, h}, std::pair{b.t1, next}}) {
      const Vec2 uv = model.on_coedge(b.coedge, t);
      // At a pole, where a whole line of parameters is one point, each triangle has its own.
      const SurfaceDerivatives s = model.chart(face).derivatives(uv);
      const double u = glm::length(s.u), v = glm::length(s.v);
      if (std::min(u, v) < 1e-9 * std::max(u, v)) continue;
      if (!(glm::length(uv - mesh.uv[corner]) <= 1e-6 * (1 + glm::length(uv)))) {
        return fmt::format("corner {} has ({},{}), its coedge ({},{})", corner, mesh.uv[corner].x,
                           mesh.uv[corner].y, uv.x, uv.y);
      }
    }
  }
  for (std::uint32_t f = 0; f < tri.triangles.size(); ++f) {
    const Chart& chart = model.chart(mesh.face[f]);
    const Vec2 uv = (mesh.uv[3 * f] + mesh.uv[3 * f + 1] + mesh.uv[3 * f + 2]) / 3.0;
    const Vec3 n = chart_normal(chart.derivatives(uv), model.reversed(mesh.face[f]), uv,
                                chart.domain().center());
    const double facing = glm::dot(n, tri.normal(f));
    if (!(facing > 0)) {
      return fmt::format("triangle {} of face {} is turned ({}, area {})", f, mesh.face[f], facing,
                         tri.area(f));
    }
  }
  return {};
}

double area(const ChartMesh& mesh) {
  const TriMesh tri = triangles_of(mesh);
  double sum = 0;
  for (std::uint32_t f = 0; f < tri.triangles.size(); ++f) sum += tri.area(f);
  return sum;
}

double volume(const ChartMesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    sum +=
        glm::dot(mesh.positions[t[0]], glm::cross(mesh.positions[t[1]], mesh.positions[t[2]])) / 6;
  }
  return sum;
}

int euler_characteristic(const ChartMesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  return static_cast<int>(mesh.positions.size()) - static_cast<int>(edges.size()) +
         static_cast<int>(mesh.triangles.size());
}

int open_half_edges(const ChartMesh& mesh) {
  const Topology t = build_topology(triangles_of(mesh), RunContext());
  return static_cast<int>(std::ranges::count(t.opposite, kNoHalfEdge));
}

int count_edges(const ChartMesh& mesh, ModelEdgeClass which) {
  return static_cast<int>(std::ranges::count(mesh.edge_class, which));
}

}  // namespace burin::test
