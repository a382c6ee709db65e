#include "draft.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace burin {
namespace {

constexpr std::size_t kGrain = 1024;
constexpr double kSharp = 0.99985;  // cosine of 1 degree between the normals of both sides
// What the deviation at the middles of edges and triangles may miss.
constexpr double kMargin = 1.5;

double deviation(const ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context) {
  std::vector<double> most((mesh.triangles.size() + kGrain - 1) / kGrain, 0);
  parallel_for(
      mesh.triangles.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3> points;
        std::vector<std::size_t> owner;
        for (std::size_t t = begin; t < end; ++t) {
          const Triangle& tri = mesh.triangles[t];
          const Vec3 a = mesh.positions[tri[0]], b = mesh.positions[tri[1]],
                     c = mesh.positions[tri[2]];
          points.insert(points.end(),
                        {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (a + b + c) / 3.0});
        }
        std::vector<Gradient1> g(points.size());
        f.gradients(points, g);
        for (std::size_t i = 0; i < g.size(); ++i) {
          // Beside a crease the piece that the triangle belongs to counts.
          const ImplicitFunction* side = mesh.side[begin + i / 4];
          if (side) g[i] = side->gradient(points[i]);
          const double d = std::abs(g[i].value) / glm::length(g[i].gradient);
          if (std::isfinite(d)) most[begin / kGrain] = std::max(most[begin / kGrain], d);
        }
      },
      &context);
  double d = 0;
  for (const double m : most) d = std::max(d, m);
  // Poles and the like: no triangle is farther off than its own size.
  return std::min(kMargin * d, mesh.step);
}

void find_sharp(const ExactMesh& mesh, ProxyDraft& draft) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, std::size_t>> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t u = mesh.triangles[t][k], v = mesh.triangles[t][(k + 1) % 3];
      if (!mesh.on_crease(u) || !mesh.on_crease(v)) continue;
      edges.emplace_back(std::min(u, v), std::max(u, v), 3 * t + k);
    }
  }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const auto& [u, v, h] = edges[i];
    const auto& [x, y, o] = edges[i + 1];
    if (u != x || v != y) continue;
    const auto next = [](std::size_t e) { return e % 3 == 2 ? e - 2 : e + 1; };
    const double a = glm::dot(draft.corner_normal[h], draft.corner_normal[next(o)]);
    const double b = glm::dot(draft.corner_normal[next(h)], draft.corner_normal[o]);
    draft.sharp[h] = draft.sharp[o] = std::min(a, b) < kSharp;
  }
}

}  // namespace

ProxyDraft make_draft(const ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context) {
  ProxyDraft draft;
  constexpr std::uint32_t kUnused = 0xffffffff;
  std::vector<std::uint32_t> name(mesh.positions.size(), kUnused);
  draft.mesh.triangles = mesh.triangles;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) name[v] = 0;
  }
  for (std::size_t v = 0; v < name.size(); ++v) {
    if (name[v] == kUnused) continue;
    name[v] = static_cast<std::uint32_t>(draft.mesh.positions.size());
    draft.mesh.positions.push_back(mesh.positions[v]);
  }
  for (Triangle& t : draft.mesh.triangles) {
    for (std::uint32_t& v : t) v = name[v];
  }
  const std::size_t corners = 3 * mesh.triangles.size();
  draft.corner_normal.resize(corners);
  draft.corner_on_contour.resize(corners);
  draft.sharp.assign(corners, 0);
  parallel_for(
      mesh.triangles.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          for (std::size_t k = 0; k < 3; ++k) {
            draft.corner_normal[3 * t + k] = mesh.corner_normal(t, k);
            draft.corner_on_contour[3 * t + k] = mesh.corner_zero(t, k);
          }
        }
      },
      &context);
  find_sharp(mesh, draft);
  draft.tolerance = deviation(mesh, f, context);
  return draft;
}

}  // namespace burin
