// Slivers beside lines, collapsed.

#include <burin/base/groups.h>

#include "exact_mesh.h"

#include <array>
#include <cmath>
#include <tuple>
#include <unordered_map>

namespace burin {
namespace {

// Share of the limit below which two points of one crease become one.
constexpr double kSamePlace = 0.2;
// Steps that the points of a triangle that lies face down may be drawn together.
constexpr double kFold = 1;
// Cosine that a triangle's plane may turn away from the surface's normal.
constexpr double kMostTilted = 0.4;
// Least height of a triangle made by a collapse, as a share of its longest side.
constexpr double kFlattest = 0.03;

class Collapser {
 public:
  Collapser(ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context)
      : mesh_(mesh), f_(f), context_(context), dead_(mesh.triangles.size(), 0) {
    around_ = grouped(
        mesh.positions.size(), mesh.triangles.size(),
        [&](std::size_t t) { return mesh.triangles[t]; },
        [](std::size_t t) {
          const auto face = static_cast<std::uint32_t>(t);
          return std::array{face, face, face};
        });
  }

  void run(double limit) {
    using Candidate = std::tuple<double, std::uint32_t, std::uint32_t>;
    std::vector<Candidate> candidates;
    for (std::size_t f = 0; f < mesh_.triangles.size(); ++f) {
      const Triangle& t = mesh_.triangles[f];
      const bool fold = folded(f, 2);
      for (std::size_t k = 0; k < 3; ++k) {
        for (const auto& [u, v] :
             {std::pair(t[k], t[(k + 1) % 3]), std::pair(t[(k + 1) % 3], t[k])}) {
          const double d = glm::distance(mesh_.positions[u], mesh_.positions[v]),
                       share = allowed(u, v);
          const double far = fold && share > 0 ? kFold : limit * share;
          if (d < far * mesh_.step_at(u)) candidates.emplace_back(d, u, v);
        }
      }
    }
    std::ranges::sort(candidates);
    std::size_t n = 0;
    for (const auto& [d, u, v] : candidates) {
      if (++n % 4096 == 0) context_.check();
      if (!gone_.contains(u) && !gone_.contains(v)) collapse(u, v);
    }
    take_out_pockets();
    compact();
  }

 private:
  bool on_line(std::uint32_t v) const { return mesh_.on_crease(v) || mesh_.zero[v]; }

  // Whether a triangle with so many points on creases lies face down: the points of a crease go
  // back and forth.
  bool folded(std::size_t t, int points) const {
    const Triangle& tri = mesh_.triangles[t];
    int on = 0;
    Vec3 normal(0);
    for (std::size_t k = 0; k < 3; ++k) {
      on += mesh_.on_crease(tri[k]);
      normal += mesh_.corner_normal(t, k);
    }
    if (on < points) return false;
    const Vec3 a = mesh_.positions[tri[0]];
    return glm::dot(glm::cross(mesh_.positions[tri[1]] - a, mesh_.positions[tri[2]] - a), normal) <
           0;
  }

  // Share of the limit up to which u may be drawn to v: 0 = never.
  double allowed(std::uint32_t u, std::uint32_t v) const {
    if (!on_line(v)) return 0;
    if (!on_line(u)) return 1;
    if (!mesh_.on_crease(u) && !mesh_.on_crease(v)) return kSamePlace;  // along a contour
    if (!mesh_.on_crease(u) || !mesh_.on_crease(v)) return 0;
    // Along a crease, or into the corner at its end.
    const auto &a = mesh_.creases[static_cast<std::size_t>(mesh_.crease[u])].sides,
               &b = mesh_.creases[static_cast<std::size_t>(mesh_.crease[v])].sides;
    for (const auto& s : a) {
      if (s.zero) return 0;
      if (std::ranges::none_of(b, [&](const auto& o) { return o.piece == s.piece; })) return 0;
    }
    return kSamePlace;
  }

  std::vector<std::uint32_t> around(std::uint32_t v) const {
    if (const auto it = changed_.find(v); it != changed_.end()) return it->second;
    const auto list = around_[v];
    return {list.begin(), list.end()};
  }

  static bool has(const Triangle& t, std::uint32_t v) {
    return t[0] == v || t[1] == v || t[2] == v;
  }

  std::vector<std::uint32_t> neighbours(const std::vector<std::uint32_t>& faces,
                                        std::uint32_t v) const {
    std::vector<std::uint32_t> out;
    for (const std::uint32_t t : faces) {
      for (const std::uint32_t w : mesh_.triangles[t]) {
        if (w != v) out.push_back(w);
      }
    }
    std::ranges::sort(out);
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
  }

  bool sound(std::uint32_t t, std::uint32_t u, std::uint32_t v) const {
    Vec3 p[3], normal(0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t w = mesh_.triangles[t][k];
      p[k] = mesh_.positions[w == u ? v : w];
      if (w == u) normal = mesh_.corner_normal(t, k);
    }
    const Vec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double area = glm::length(n);
    const double longest =
        std::max({glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
    return area > kFlattest * longest * longest && glm::dot(n, normal) > kMostTilted * area;
  }

  void collapse(std::uint32_t u, std::uint32_t v) {
    const std::vector<std::uint32_t> of_u = around(u), of_v = around(v);
    std::vector<std::uint32_t> shared, kept;
    for (const std::uint32_t t : of_u) {
      (has(mesh_.triangles[t], v) ? shared : kept).push_back(t);
    }
    if (shared.size() != 2) return;
    // The surface stays a manifold where the ends of the edge have two common neighbours alone.
    const auto a = neighbours(of_u, u), b = neighbours(of_v, v);
    std::vector<std::uint32_t> common;
    std::ranges::set_intersection(a, b, std::back_inserter(common));
    if (common.size() != 2) return;
    for (const std::uint32_t w : common) {
      if (around(w).size() <= 3) return;
    }
    for (const std::uint32_t t : kept) {
      if (!sound(t, u, v)) return;
    }
    for (const std::uint32_t t : kept) {
      if (mesh_.on_crease(v) && !mesh_.side[t] && !mesh_.on_crease(u)) {
        mesh_.side[t] = &f_.piece_function(mesh_.positions[u]);
      }
      for (std::uint32_t& w : mesh_.triangles[t]) {
        if (w == u) w = v;
      }
    }
    for (const std::uint32_t t : shared) dead_[t] = 1;
    const auto without_dead = [&](std::vector<std::uint32_t> faces) {
      std::erase_if(faces, [&](std::uint32_t t) { return dead_[t] != 0; });
      return faces;
    };
    std::vector<std::uint32_t> now = without_dead(of_v);
    now.insert(now.end(), kept.begin(), kept.end());
    changed_[v] = std::move(now);
    for (const std::uint32_t w : common) changed_[w] = without_dead(around(w));
    gone_.emplace(u, true);
  }

  // A crease's vertex whose only three triangles lie on one side of the crease, one of them face
  // down: flips have left it so. The triangle of its neighbours takes their place; slivers are
  // flipped afterwards.
  void take_out_pockets() {
    for (std::uint32_t t = 0; t < dead_.size(); ++t) {
      if (dead_[t] || !folded(t, 1)) continue;
      for (const std::uint32_t v : Triangle(mesh_.triangles[t])) {
        if (mesh_.on_crease(v) && take_out_pocket(v)) break;
      }
    }
  }

  bool take_out_pocket(std::uint32_t v) {
    const std::vector<std::uint32_t> fan = around(v);
    if (fan.size() != 3) return false;
    // The sides opposite to v, one after the other.
    std::array<std::array<std::uint32_t, 2>, 3> opposite;
    for (std::size_t i = 0; i < 3; ++i) {
      const Triangle& tri = mesh_.triangles[fan[i]];
      const auto k = static_cast<std::size_t>(std::ranges::find(tri, v) - tri.begin());
      opposite[i] = {tri[(k + 1) % 3], tri[(k + 2) % 3]};
    }
    if (opposite[1][0] != opposite[0][1]) std::swap(opposite[1], opposite[2]);
    if (opposite[1][0] != opposite[0][1] || opposite[2][0] != opposite[1][1] ||
        opposite[0][0] != opposite[2][1]) {
      return false;
    }
    const Triangle whole{opposite[0][0], opposite[1][0], opposite[2][0]};
    for (const std::uint32_t w : whole) {
      if (around(w).size() <= 4) return false;
    }
    mesh_.triangles[fan[0]] = whole;
    dead_[fan[1]] = dead_[fan[2]] = 1;
    for (const std::uint32_t w : whole) {
      std::vector<std::uint32_t> now = around(w);
      std::erase_if(now, [&](std::uint32_t t) { return dead_[t] != 0 || t == fan[0]; });
      now.push_back(fan[0]);
      changed_[w] = std::move(now);
    }
    changed_[v].clear();
    gone_.emplace(v, true);
    return true;
  }

  void compact() {
    std::size_t n = 0;
    for (std::size_t t = 0; t < dead_.size(); ++t) {
      if (dead_[t]) continue;
      mesh_.triangles[n] = mesh_.triangles[t];
      mesh_.side[n++] = mesh_.side[t];
    }
    mesh_.triangles.resize(n);
    mesh_.side.resize(n);
  }

  ExactMesh& mesh_;
  const ImplicitFunction& f_;
  const RunContext& context_;
  std::vector<std::uint8_t> dead_;
  // Triangles around each vertex as they were, and as they are now where that has changed.
  Groups<std::uint32_t> around_;  // triangles at the vertices, as they came
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> changed_;
  std::unordered_map<std::uint32_t, bool> gone_;
};

}  // namespace

void collapse_slivers(ExactMesh& mesh, const ImplicitFunction& f, double limit,
                      const RunContext& context) {
  Collapser(mesh, f, context).run(limit);
}

}  // namespace burin
