#include "wide_triangles.h"

#include <burin/base/box.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace burin {
namespace {

/// Three edges at the least lead round: no two of them have both ends in common.
constexpr double kWide = 0.34;
/// A face reaches round once. Where a seam's sides are nearer than this share of what the face has
/// of (u,v) they were torn out of place.
constexpr double kTorn = 0.5;
/// Every pass halves; edges wait for one of their triangles some times.
constexpr int kPasses = 64;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct WideEdge {
  double width = 0;
  Edge edge;
  std::array<std::size_t, 2> triangle{};
};

Edge edge_of(const Triangle& t, std::size_t k) { return std::minmax(t[k], t[(k + 1) % 3]); }

/// Of the way round; above kWide it is too wide.
double width(const std::vector<Vec2>& uv, const Edge& e, Vec2 around) {
  const Vec2 d = glm::abs(uv[e.second] - uv[e.first]);
  double w = 0;
  for (int i = 0; i < 2; ++i) {
    if (around[i] > 0) w = std::max(w, d[i] / around[i]);
  }
  return w;
}

/// Edges with two triangles, the widest first.
std::vector<WideEdge> wide_edges(const std::vector<Vec2>& uv, const std::vector<std::uint8_t>& pole,
                                 const std::vector<Triangle>& triangles, Vec2 around) {
  std::map<Edge, std::vector<std::size_t>> uses;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge e = edge_of(triangles[f], k);
      if (pole[e.first] || pole[e.second]) continue;
      if (width(uv, e, around) > kWide) uses[e].push_back(f);
    }
  }
  std::vector<WideEdge> out;
  for (const auto& [edge, faces] : uses) {
    if (faces.size() != 2) continue;
    out.push_back({width(uv, edge, around), edge, {faces[0], faces[1]}});
  }
  std::ranges::stable_sort(out,
                           [](const WideEdge& a, const WideEdge& b) { return a.width > b.width; });
  return out;
}

/// (a, b, c) becomes (a, m, c) and (m, b, c).
void split(std::vector<Triangle>& triangles, std::size_t f, const Edge& edge, std::uint32_t m) {
  std::size_t k = 0;
  while (edge_of(triangles[f], k) != edge) ++k;
  Triangle second = triangles[f];
  triangles[f][(k + 1) % 3] = m;
  second[k] = m;
  triangles.push_back(second);
}

}  // namespace

void split_wide_triangles(std::vector<Vec2>& uv, std::vector<std::uint8_t>& pole,
                          std::vector<Triangle>& triangles, Vec2 around) {
  Box2 box;
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) box.add(uv[v]);
  }
  for (int i = 0; i < 2; ++i) {
    if (around[i] < kTorn * box.size()[i]) around[i] = 0;
  }
  if (!(around.x > 0) && !(around.y > 0)) return;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<WideEdge> wide = wide_edges(uv, pole, triangles, around);
    if (wide.empty()) return;
    std::vector<std::uint8_t> changed(triangles.size(), 0);
    for (const WideEdge& w : wide) {
      const auto [f, g] = w.triangle;
      if (changed[f] || changed[g]) continue;
      changed[f] = changed[g] = 1;
      const auto m = static_cast<std::uint32_t>(uv.size());
      uv.push_back(0.5 * (uv[w.edge.first] + uv[w.edge.second]));
      pole.push_back(0);
      split(triangles, f, w.edge, m);
      split(triangles, g, w.edge, m);
    }
  }
}

}  // namespace burin
