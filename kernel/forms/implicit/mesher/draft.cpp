#include "draft.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace burin {
namespace {

constexpr std::size_t kDraftGrain = 1024;
constexpr double kSharp = 0.99985;  // cosine of 1 degree between the normals of both sides
// What the deviation at the middles of edges and triangles may miss.
constexpr double kMissedDeviation = 1.5;

double deviation(const ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context) {
  double most = 0;
  for (const double d : deviations(mesh, f, context)) most = std::max(most, d);
  // Poles and the like: no triangle is farther off than its own size.
  return std::min(kMissedDeviation * most, mesh.step);
}

}  // namespace

std::vector<double> deviations(const ExactMesh& mesh, const ImplicitFunction& f,
                               const RunContext& context) {
  std::vector<double> out(mesh.triangles.size(), 0);
  parallel_for(
      mesh.triangles.size(), kDraftGrain,
      [&](std::size_t begin, std::size_t end) {
        // The middles of the triangles and of their longest edges, where chords are farthest off.
        const std::size_t n = end - begin;
        std::vector<Vec3> centers(n), middles(n);
        for (std::size_t t = begin; t < end; ++t) {
          Vec3 p[3];
          for (std::size_t k = 0; k < 3; ++k) p[k] = mesh.positions[mesh.triangles[t][k]];
          centers[t - begin] = (p[0] + p[1] + p[2]) / 3.0;
          double longest = -1;
          for (std::size_t k = 0; k < 3; ++k) {
            const double l = glm::distance(p[k], p[(k + 1) % 3]);
            if (l <= longest) continue;
            longest = l;
            middles[t - begin] = 0.5 * (p[k] + p[(k + 1) % 3]);
          }
        }
        std::vector<Gradient1> g(n);
        std::vector<double> v(n);
        f.gradients(centers, g);
        f.values(middles, v);
        for (std::size_t i = 0; i < n; ++i) {
          // Beside a crease the piece that the triangle belongs to counts.
          if (const ImplicitFunction* side = mesh.side[begin + i]) {
            g[i] = side->gradient(centers[i]);
            v[i] = side->value(middles[i]);
          }
          const double d =
              std::max(std::abs(g[i].value), std::abs(v[i])) / glm::length(g[i].gradient);
          if (std::isfinite(d)) out[begin + i] = d;
        }
      },
      &context);
  return out;
}

std::vector<std::uint8_t> sharp_halves(const ExactMesh& mesh, std::span<const Vec3> corner_normal) {
  std::vector<std::uint8_t> sharp(3 * mesh.triangles.size(), 0);
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
    const double a = glm::dot(corner_normal[h], corner_normal[next(o)]);
    const double b = glm::dot(corner_normal[next(h)], corner_normal[o]);
    sharp[h] = sharp[o] = std::min(a, b) < kSharp;
  }
  return sharp;
}

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
  parallel_for(
      mesh.triangles.size(), kDraftGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
          for (std::size_t k = 0; k < 3; ++k) {
            draft.corner_normal[3 * t + k] = mesh.corner_normal(t, k);
            draft.corner_on_contour[3 * t + k] = mesh.corner_zero(t, k);
          }
        }
      },
      &context);
  draft.sharp = sharp_halves(mesh, draft.corner_normal);
  draft.tolerance = deviation(mesh, f, context);
  return draft;
}

}  // namespace burin
