#include "tessellate.h"

#include <burin/base/parallel.h>
#include <burin/forms/charted/refine.h>
#include <burin/work_mesh/half_edges.h>

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Rounds of measuring and planning anew; the second derivatives that plan the grid miss little.
constexpr int kRounds = 4;
// A grid that is so many times too coarse is so at some spots, where its triangles are split.
constexpr double kSpots = 2;
// Between the places that are measured the triangles can be a little farther off.
constexpr double kMeasureMargin = 1.05;

/// Nodes of an edge: ascending t and the vertices there.
struct EdgeNodes {
  std::vector<double> t;
  std::vector<std::uint32_t> vertex;
};

// The grid lines of the face that asks for more, so that its triangles are regular up to the edge.
EdgeNodes edge_nodes(ChartMesh& mesh, const PatchComplex& complex,
                     const std::vector<FaceGrid>& grids, const PatchEdge& edge) {
  const PatchAtlas& atlas = *complex.atlas;
  EdgeNodes nodes;
  for (const std::int32_t coedge : edge.coedge) {
    if (coedge < 0) continue;
    const SideUse& use = atlas.uses()[static_cast<std::size_t>(coedge)];
    const int direction = side_direction(use.side);
    const auto& lines = grids[static_cast<std::size_t>(use.face)].lines[direction];
    if (lines.size() <= nodes.t.size()) continue;
    nodes.t.clear();
    const double low = lines.front(), size = lines.back() - low;
    for (const double x : lines) {
      const double s = (x - low) / size;
      nodes.t.push_back(atlas.edge_t(coedge, side_descends(use.side) ? 1 - s : s));
    }
    std::sort(nodes.t.begin(), nodes.t.end());
    nodes.t.front() = 0;
    nodes.t.back() = 1;
  }
  const SideUse& use = atlas.uses()[static_cast<std::size_t>(edge.coedge[0])];
  const Chart& chart = atlas.chart(use.face);
  for (std::size_t i = 0; i < nodes.t.size(); ++i) {
    const bool tip = i == 0 || i + 1 == nodes.t.size();
    if (tip) {
      nodes.vertex.push_back(edge.vertex[i == 0 ? 0 : 1]);
      continue;
    }
    nodes.vertex.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(chart.position(side_uv(chart.domain(), use.side, nodes.t[i])));
  }
  return nodes;
}

std::vector<SideNode> side_nodes(const PatchComplex& complex, std::int32_t face, int side,
                                 const std::vector<EdgeNodes>& edges) {
  const auto f = static_cast<std::size_t>(face), s = static_cast<std::size_t>(side);
  const std::int32_t coedge = complex.coedge[f][s];
  if (coedge < 0) return {{complex.corner[f][s], 0, 0}};
  const SideUse& use = complex.atlas->uses()[static_cast<std::size_t>(coedge)];
  const EdgeNodes& nodes = edges[static_cast<std::size_t>(use.edge)];
  std::vector<SideNode> result;
  for (std::size_t i = 0; i < nodes.t.size(); ++i) {
    result.push_back({nodes.vertex[i], complex.atlas->side_t(coedge, nodes.t[i]), nodes.t[i]});
  }
  if (use.backward) std::reverse(result.begin(), result.end());
  return result;
}

RawMesh build(const PatchComplex& complex, const std::vector<FaceGrid>& grids,
              const RunContext& context) {
  RawMesh raw;
  ChartMesh& mesh = raw.mesh;
  mesh.positions = complex.vertices;
  std::vector<EdgeNodes> edges;
  for (const PatchEdge& edge : complex.edges) {
    edges.push_back(edge_nodes(mesh, complex, grids, edge));
    mesh.edge_class.push_back(edge.kind);
  }
  for (std::size_t f = 0; f < grids.size(); ++f) {
    context.check();
    const auto face = static_cast<std::int32_t>(f);
    std::array<std::vector<SideNode>, 4> sides;
    for (int s = 0; s < 4; ++s) {
      sides[static_cast<std::size_t>(s)] = side_nodes(complex, face, s, edges);
    }
    add_face(raw, complex, face, grids[f], sides);
  }
  return raw;
}

// The direction that has no length at a corner, -1 where it is no pole.
int collapsed_at(const PatchComplex& complex, std::size_t face, std::uint32_t vertex) {
  for (int s = 0; s < 4; ++s) {
    const auto side = static_cast<std::size_t>(s);
    if (complex.coedge[face][side] < 0 && complex.corner[face][side] == vertex) {
      return side_direction(s);
    }
  }
  return -1;
}

// How far the points of a triangle are from S at the same (u,v): its middle and those of its sides.
// At a pole (u,v) follows the rays from it, as everywhere.
struct Distance {
  double normal = 0, full = 0;
};
Distance distance_off(const ChartMesh& mesh, const PatchComplex& complex, std::size_t triangle) {
  const auto face = static_cast<std::size_t>(mesh.face[triangle]);
  const Chart& chart = complex.atlas->chart(mesh.face[triangle]);
  const Triangle& t = mesh.triangles[triangle];
  std::array<int, 3> collapsed{-1, -1, -1};
  for (std::size_t k = 0; k < 3; ++k) {
    if (t[k] < complex.vertices.size()) collapsed[k] = collapsed_at(complex, face, t[k]);
  }
  const Vec3 corner = mesh.positions[t[0]];
  const Vec3 normal = normalize_or(
      glm::cross(mesh.positions[t[1]] - corner, mesh.positions[t[2]] - corner), Vec3(0));
  Distance largest;
  for (std::size_t k = 0; k < 4; ++k) {
    Vec3 weight(1.0 / 3);
    if (k < 3) {
      // A side inside a face is measured in one of its triangles.
      if (mesh.border[3 * triangle + (k + 1) % 3] < 0 && t[(k + 1) % 3] > t[(k + 2) % 3]) continue;
      weight = Vec3(0.5);
      weight[static_cast<int>(k)] = 0;
    }
    Vec2 uv(0);
    Vec3 p(0);
    for (std::size_t c = 0; c < 3; ++c) {
      uv += weight[static_cast<int>(c)] * mesh.uv[3 * triangle + c];
      p += weight[static_cast<int>(c)] * mesh.positions[t[c]];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const int i = collapsed[c];
      if (i < 0) continue;
      const std::size_t a = (c + 1) % 3, b = (c + 2) % 3;
      const double wa = weight[static_cast<int>(a)], wb = weight[static_cast<int>(b)];
      uv[i] = (wa * mesh.uv[3 * triangle + a][i] + wb * mesh.uv[3 * triangle + b][i]) / (wa + wb);
    }
    const Vec3 gap = p - chart.position(uv);
    largest.full = std::max(largest.full, glm::length(gap));
    largest.normal = std::max(largest.normal, std::abs(glm::dot(gap, normal)));
  }
  return largest;
}

// The largest of each face.
std::vector<Distance> measure(const ChartMesh& mesh, const PatchComplex& complex,
                              const RunContext& context) {
  std::vector<Distance> off(mesh.triangles.size());
  parallel_for(
      off.size(), 1024,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) off[i] = distance_off(mesh, complex, i);
      },
      &context);
  std::vector<Distance> largest(complex.atlas->face_count());
  for (std::size_t i = 0; i < off.size(); ++i) {
    Distance& m = largest[static_cast<std::size_t>(mesh.face[i])];
    m.normal = std::max(m.normal, kMeasureMargin * off[i].normal);
    m.full = std::max(m.full, kMeasureMargin * off[i].full);
  }
  return largest;
}

// Two triangles may not share two sides: an edge has two segments at least, a closed one three.
std::array<int, 2> least_cells(const PatchComplex& complex, std::size_t face) {
  std::array<int, 2> least{2, 2};
  for (int s = 0; s < 4; ++s) {
    const std::int32_t coedge = complex.coedge[face][static_cast<std::size_t>(s)];
    if (coedge < 0) continue;
    const SideUse& use = complex.atlas->uses()[static_cast<std::size_t>(coedge)];
    const PatchEdge& edge = complex.edges[static_cast<std::size_t>(use.edge)];
    if (edge.vertex[0] == edge.vertex[1]) least[static_cast<std::size_t>(side_direction(s))] = 3;
  }
  return least;
}

std::size_t cells(const FaceGrid& grid) {
  return (grid.lines[0].size() - 1) * (grid.lines[1].size() - 1);
}

/// The grids for these distances; all coarser where they have more than `most` triangles together.
std::vector<FaceGrid> grids_for(const PatchComplex& complex, const std::vector<GridPlan>& plans,
                                const std::vector<double>& distance, std::size_t most) {
  std::vector<FaceGrid> grids(plans.size());
  double share = 1;
  for (int i = 0; i < kRounds; ++i) {
    std::size_t triangles = 0;
    for (std::size_t f = 0; f < plans.size(); ++f) {
      grids[f] = plans[f].lines(distance[f], share, least_cells(complex, f));
      triangles += 2 * cells(grids[f]);
    }
    if (triangles <= most) break;
    share *= 0.95 * std::sqrt(static_cast<double>(most) / static_cast<double>(triangles));
  }
  return grids;
}

}  // namespace

Tessellation tessellate(const PatchComplex& complex, double tolerance, const RunContext& context) {
  const std::size_t faces = complex.atlas->face_count();
  // Finer than rounding allows, or nothing at all, is no tolerance.
  const double wanted = std::max(tolerance, 1e-9 * complex.size);
  const std::size_t most = triangle_bound(complex.size, wanted);
  std::vector<GridPlan> plans;
  for (std::size_t f = 0; f < faces; ++f) {
    plans.emplace_back(complex.atlas->chart(static_cast<std::int32_t>(f)));
  }
  std::vector<double> distance(faces, wanted);
  RawMesh raw;
  Tessellation made;
  for (int round = 1;; ++round) {
    // Half of the bound is left for the spots.
    raw = build(complex, grids_for(complex, plans, distance, most / 2), context);
    const std::vector<Distance> off = measure(raw.mesh, complex, context);
    bool again = false, fine = true;
    for (std::size_t f = 0; f < faces; ++f) {
      raw.mesh.tolerance = std::max(raw.mesh.tolerance, off[f].full);
      const double excess = std::max(off[f].normal, off[f].full / kAlong) / wanted;
      if (excess <= 1) continue;
      fine = false;
      if (excess > kSpots) continue;
      distance[f] *= 0.95 / excess;
      again = true;
    }
    if (again && round < kRounds) continue;
    if (!fine) {
      auto opposite = pair_half_edges(raw.mesh.triangles, raw.mesh.positions.size());
      made.complete = refine(raw, {std::move(opposite), {}}, *complex.atlas,
                             {wanted / kMeasureMargin, kAlong, most}, context);
      raw.mesh.tolerance *= kMeasureMargin;
    }
    break;
  }
  made.mesh = std::move(raw.mesh);
  made.mesh.normal.assign(made.mesh.uv.size(), Vec3(0));
  made.mesh.on_contour.assign(made.mesh.uv.size(), 0);
  return made;
}

}  // namespace burin::detail
