// Tips of cones: points of the surface without a normal, which Newton along the gradient never
// reaches.

#include "tips.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <span>

namespace burin {
namespace {

// Cosine of the angle between the normals of neighbours of one piece from which a tip may be there.
constexpr double kTurned = 0.7;
// Steps that a tip may lie away from the vertices around it, and share of one that their tangent
// planes may miss it.
constexpr double kTipReach = 12, kMiss = 0.02;
// More of them mean a rough surface.
constexpr std::size_t kMostVertices = 4000, kMostTips = 100;

using Ring = std::set<std::uint32_t>;

// Neighbours of one piece whose normals differ much, each with all vertices of its polygons.
std::map<std::uint32_t, Ring> turned_rings(const ExactMesh& mesh, const Nets& nets) {
  std::map<std::uint32_t, Ring> rings;
  const auto polygon = [&](std::size_t k) {
    return std::span(nets.corners)
        .subspan(nets.first_corner[k], nets.first_corner[k + 1] - nets.first_corner[k]);
  };
  for (std::size_t k = 0; k + 1 < nets.first_corner.size(); ++k) {
    for (const std::uint32_t u : polygon(k)) {
      for (const std::uint32_t v : polygon(k)) {
        if (u == v || mesh.pieces[u] != mesh.pieces[v] || mesh.on_crease(u) || mesh.on_crease(v)) {
          continue;
        }
        if (glm::dot(mesh.normals[u], mesh.normals[v]) < kTurned) rings[u];
      }
    }
  }
  if (rings.empty() || rings.size() > kMostVertices) return {};
  for (std::size_t k = 0; k + 1 < nets.first_corner.size(); ++k) {
    for (const std::uint32_t u : polygon(k)) {
      if (const auto it = rings.find(u); it != rings.end()) {
        it->second.insert(polygon(k).begin(), polygon(k).end());
      }
    }
  }
  return rings;
}

// The point nearest to all tangent planes of a ring, if it is one.
std::optional<Vec3> common_point(const ExactMesh& mesh, std::uint32_t v, const Ring& ring) {
  Mat3 a(0);
  Vec3 b(0);
  const Vec3 o = mesh.positions[v];
  for (const std::uint32_t w : ring) {
    if (mesh.pieces[w] != mesh.pieces[v] || mesh.on_crease(w)) continue;
    const Vec3 n = mesh.normals[w];
    a += glm::outerProduct(n, n);
    b += glm::dot(n, mesh.positions[w] - o) * n;
  }
  const double det = glm::determinant(a);
  if (!(std::abs(det) > 1e-3)) return std::nullopt;  // planes in a row: an edge, a tight bend
  const Vec3 x = glm::inverse(a) * b;
  if (!(glm::length(x) < kTipReach * mesh.step)) return std::nullopt;
  for (const std::uint32_t w : ring) {
    if (mesh.pieces[w] != mesh.pieces[v] || mesh.on_crease(w)) continue;
    const double miss = glm::dot(mesh.normals[w], o + x - mesh.positions[w]);
    if (std::abs(miss) > kMiss * mesh.step) return std::nullopt;
  }
  return o + x;
}

// Puts vertex v to the tip and a fan of triangles from there to the border of what lies within
// `reach` of it; false where that is no disc around the tip.
bool fan(ExactMesh& mesh, std::uint32_t v, Vec3 tip, double reach) {
  const auto inside = [&](std::uint32_t w) {
    return w == v || (mesh.pieces[w] == mesh.pieces[v] && !mesh.on_crease(w) &&
                      glm::distance(mesh.positions[w], tip) < reach);
  };
  std::set<std::pair<std::uint32_t, std::uint32_t>> halves;
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    if (!inside(t[0]) && !inside(t[1]) && !inside(t[2])) {
      kept.push_back(t);
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) halves.emplace(t[k], t[(k + 1) % 3]);
  }
  std::map<std::uint32_t, std::uint32_t> border;
  for (const auto& [a, b] : halves) {
    if (halves.contains({b, a})) continue;
    if (inside(a) || inside(b) || !border.emplace(a, b).second) return false;
  }
  if (border.size() < 3) return false;
  std::uint32_t a = border.begin()->first;
  for (std::size_t i = 0; i < border.size(); ++i) {
    const auto it = border.find(a);
    if (it == border.end() || (i > 0 && a == border.begin()->first)) return false;
    const std::uint32_t b = it->second;
    const Vec3 n = glm::cross(mesh.positions[b] - mesh.positions[a], tip - mesh.positions[a]);
    const bool sound = mesh.pieces[a] == mesh.pieces[v] && !mesh.on_crease(a) &&
                       glm::dot(n, mesh.normals[a]) > 0 && glm::dot(n, mesh.normals[b]) > 0;
    if (!sound) return false;
    kept.push_back({a, b, v});
    a = b;
  }
  if (a != border.begin()->first) return false;
  mesh.triangles = std::move(kept);
  mesh.positions[v] = tip;
  mesh.normals[v] = Vec3(0);
  mesh.zero[v] = 1;
  return true;
}

}  // namespace

void place_tips(ExactMesh& mesh, const ImplicitFunction& f, const Nets& nets) {
  struct Tip {
    std::uint32_t vertex = 0;
    Vec3 position{0};
    double distance = 0;
  };
  std::vector<Tip> tips;
  for (const auto& [v, ring] : turned_rings(mesh, nets)) {
    const auto x = common_point(mesh, v, ring);
    // Of the surface, and without a normal there: beside it the value grows to all sides alike.
    if (!x || !(std::abs(f.value(*x)) <= 1e-7 * mesh.size)) continue;
    tips.push_back({v, *x, glm::distance(*x, mesh.positions[v])});
  }
  std::ranges::stable_sort(tips, {}, &Tip::distance);
  std::vector<Vec3> taken;
  for (const Tip& t : tips) {
    const bool near = std::ranges::any_of(
        taken, [&](const Vec3& p) { return glm::distance(p, t.position) < 0.5 * mesh.step; });
    if (near || taken.size() >= kMostTips) continue;
    if (!fan(mesh, t.vertex, t.position, t.distance + mesh.step)) continue;
    taken.push_back(t.position);
  }
}

}  // namespace burin
