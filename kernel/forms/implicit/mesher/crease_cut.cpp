// Edges of solids: where two pieces of the function meet at an angle.

#include <burin/base/parallel.h>

#include "../function/project.h"
#include "exact_mesh.h"

#include <array>
#include <cmath>
#include <optional>

namespace burin {
namespace {

// Edge lengths that a point on a crease may lie away from the edge that it cuts; where the edge
// passes behind a thin wedge, so far as its two faces take to meet, and half as far again (two
// degrees take 28).
constexpr double kCreaseReach = 3, kFarthest = 28, kSlack = 1.5;
// Nanoseconds a triangle for what sorts out slivers.
constexpr double kSorting = 2000;

CreaseVertex::Side side(const ImplicitFunction& piece, Vec3 p) {
  return {&piece, normalize_or(piece.gradient(p).gradient, Vec3(0))};
}

bool on_surface(const ExactMesh& mesh, const ImplicitFunction& f, Vec3 p) {
  const Gradient1 g = f.gradient(p);
  return std::abs(g.value) <= 1e-9 * mesh.size * std::max(1e-12, glm::length(g.gradient));
}

class CreaseCutter {
 public:
  CreaseCutter(ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context)
      : mesh_(mesh), f_(f), context_(context) {}

  void cut() {
    const auto edges = mixed_edges();
    // The place of the change by halving, then Newton for the crease.
    const double each = 30 * work::kPiece * f_.cost();
    mesh_.budget.spend(static_cast<double>(edges.size()), each);
    if (!edges.empty()) mesh_.budget.spend(static_cast<double>(mesh_.triangles.size()), kSorting);
    std::vector<std::optional<Meeting>> found(edges.size());
    parallel_for(
        edges.size(), work::grain(each, 64),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) found[i] = crossing(edges[i][0], edges[i][1]);
        },
        &context_);
    EdgePoints points;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (!found[i]) continue;
      points.add(edges[i][0], edges[i][1],
                 mesh_.add_crease_vertex(found[i]->position, std::move(found[i]->sides)));
    }
    if (!points.empty()) {
      points.sort();
      cut_at_points(mesh_, points, [&](std::size_t t) { return corner(t, points); });
    }
    if (mesh_.creases.empty()) return;
    add_missing_corners();
    set_sides();
    flip_slivers(mesh_);
    collapse_slivers(mesh_, f_, 0.3, context_);
    flip_slivers(mesh_);
  }

 private:
  const std::vector<CreaseVertex::Side>& sides(std::uint32_t v) const {
    return mesh_.creases[static_cast<std::size_t>(mesh_.crease[v])].sides;
  }

  // Whether the piece of free vertex u runs on to crease vertex v.
  bool belongs(std::uint32_t u, std::uint32_t v) const {
    const ImplicitFunction* piece = &f_.piece_function(mesh_.positions[u]);
    return std::ranges::any_of(sides(v), [&](const auto& s) {
      return s.piece == piece || glm::dot(s.normal, mesh_.normals[u]) > kSmooth;
    });
  }

  // Edges between vertices of different pieces, a free vertex first, each once.
  std::vector<std::array<std::uint32_t, 2>> mixed_edges() const {
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const Triangle& t : mesh_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t u = t[k], v = t[(k + 1) % 3];
        // Closed and oriented: the other triangle has the edge the other way round.
        if (u > v || mesh_.pieces[u] == mesh_.pieces[v]) continue;
        const bool a = mesh_.on_crease(u), b = mesh_.on_crease(v);
        if (a && b) continue;
        if (b && belongs(u, v)) continue;
        if (a && belongs(v, u)) continue;
        edges.push_back(a ? std::array{v, u} : std::array{u, v});
      }
    }
    std::ranges::sort(edges);
    return edges;
  }

  // The first place along the edge where the piece changes at an angle.
  std::optional<Meeting> crossing(std::uint32_t u, std::uint32_t v) const {
    constexpr int kChanges = 8;
    const Vec3 a = mesh_.positions[u], b = mesh_.positions[v];
    const double length = std::max(glm::distance(a, b), mesh_.step);
    double from = 0;
    std::uint64_t name = mesh_.pieces[u];
    Vec3 at = a;
    for (int change = 0; change < kChanges && name != mesh_.pieces[v] && from < 1; ++change) {
      // [low, high] holds the end of this piece.
      double low = from, high = 1;
      for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (low + high);
        (f_.piece(a + middle * (b - a)) == name ? low : high) = middle;
      }
      const Vec3 p = low > 0 ? a + low * (b - a) : at, q = high < 1 ? a + high * (b - a) : b;
      const ImplicitFunction &i = f_.piece_function(p), &j = f_.piece_function(q);
      const Vec3 between = 0.5 * (p + q);
      const double sine = glm::length(glm::cross(side(i, p).normal, side(j, q).normal));
      const double reach =
          length * std::clamp(kSlack / std::max(sine, 1e-9), kCreaseReach, kFarthest);
      auto c = find_crease(mesh_, f_, i, j, between, reach);
      if (c && (glm::distance(c->position, between) <= kCreaseReach * length ||
                same_side(between, c->position))) {
        // Another change behind it: the edge passes by a corner.
        const ImplicitFunction& k = f_.piece_function(b);
        if (!mesh_.on_crease(v) && &k != &i && &k != &j) {
          if (auto corner = find_corner(mesh_, f_, i, j, k, c->position, reach)) return corner;
        }
        return c;
      }
      from = high;
      at = q;
      name = f_.piece(q);
    }
    return std::nullopt;
  }

  // Whether all between a and b, a point of the surface, is inside or all outside: one wedge.
  bool same_side(Vec3 a, Vec3 b) const {
    constexpr int kPlaces = 8;
    const bool inside = f_.value(a) < 0;
    for (int i = 1; i < kPlaces; ++i) {
      if ((f_.value(glm::mix(a, b, static_cast<double>(i) / kPlaces)) < 0) != inside) return false;
    }
    return true;
  }

  // The length of the longest side of a triangle of points.
  static double spread(const std::array<Vec3, 3>& p) {
    return std::max(
        {glm::distance(p[0], p[1]), glm::distance(p[1], p[2]), glm::distance(p[2], p[0])});
  }

  // The vertex inside a triangle whose three corners lie on three sides.
  std::uint32_t corner(std::size_t t, const EdgePoints& points) {
    const Triangle tri = mesh_.triangles[t];
    Vec3 middle(0);
    CreaseVertex all;
    std::array<Vec3, 3> around;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = points.find(tri[k], tri[(k + 1) % 3]);
      around[k] = mesh_.positions[p];
      middle += mesh_.positions[p] / 3.0;
      for (const auto& s : sides(p)) {
        const bool known =
            std::ranges::any_of(all.sides, [&](const auto& o) { return o.piece == s.piece; });
        if (!known) all.sides.push_back(s);
      }
    }
    const ImplicitFunction* f[3];
    for (std::size_t k = 0; k < 3; ++k) f[k] = &f_.piece_function(mesh_.positions[tri[k]]);
    const double reach = 2 * std::max(kCreaseReach * mesh_.step, spread(around));
    if (const auto c = find_corner(mesh_, f_, *f[0], *f[1], *f[2], middle, reach)) {
      return mesh_.add_crease_vertex(c->position, c->sides);
    }
    // No such corner: the sides run out into one another here.
    const auto q = onto_surface(f_, middle, kCreaseReach * mesh_.step, mesh_.accuracy);
    return mesh_.add_crease_vertex(q.value_or(middle), all);
  }

  // Triangles whose corners lie on three creases, with no piece in common, cut off a corner.
  void add_missing_corners() {
    const std::size_t count = mesh_.triangles.size();
    for (std::size_t t = 0; t < count; ++t) {
      const Triangle tri = mesh_.triangles[t];
      if (!std::ranges::all_of(tri, [&](std::uint32_t v) { return mesh_.on_crease(v); })) continue;
      std::vector<const ImplicitFunction*> pieces;
      bool shared = false;
      for (const std::uint32_t v : tri) {
        for (const auto& s : sides(v)) {
          if (std::ranges::find(pieces, s.piece) == pieces.end()) pieces.push_back(s.piece);
          shared |= std::ranges::all_of(tri, [&](std::uint32_t w) {
            return std::ranges::any_of(sides(w), [&](const auto& o) { return o.piece == s.piece; });
          });
        }
      }
      if (shared || pieces.size() != 3) continue;
      const Vec3 middle =
          (mesh_.positions[tri[0]] + mesh_.positions[tri[1]] + mesh_.positions[tri[2]]) / 3.0;
      const double reach = std::max(
          kCreaseReach * mesh_.step,
          spread({mesh_.positions[tri[0]], mesh_.positions[tri[1]], mesh_.positions[tri[2]]}));
      const auto c = find_corner(mesh_, f_, *pieces[0], *pieces[1], *pieces[2], middle, reach);
      if (!c) continue;
      const std::uint32_t v = mesh_.add_crease_vertex(c->position, c->sides);
      mesh_.triangles[t] = {tri[0], tri[1], v};
      mesh_.triangles.push_back({tri[1], tri[2], v});
      mesh_.triangles.push_back({tri[2], tri[0], v});
      mesh_.side.insert(mesh_.side.end(), 2, nullptr);
    }
  }

  // The piece of triangles that have crease vertices.
  void set_sides() {
    parallel_for(
        mesh_.triangles.size(), 1024,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t t = begin; t < end; ++t) mesh_.side[t] = side_of(mesh_.triangles[t]);
        },
        &context_);
  }
  const ImplicitFunction* side_of(const Triangle& tri) const {
    int on = 0;
    for (const std::uint32_t v : tri) on += mesh_.on_crease(v);
    if (on == 0) return nullptr;
    for (const std::uint32_t v : tri) {
      if (!mesh_.on_crease(v)) return &f_.piece_function(mesh_.positions[v]);
    }
    // All three on creases: a piece that they share, of several the one that lies as the triangle
    // does.
    const Vec3 n = glm::cross(mesh_.positions[tri[1]] - mesh_.positions[tri[0]],
                              mesh_.positions[tri[2]] - mesh_.positions[tri[0]]);
    const ImplicitFunction* best = nullptr;
    double most = -std::numeric_limits<double>::infinity();
    int most_shared = 0;
    for (const std::uint32_t v : tri) {
      for (const auto& s : sides(v)) {
        int shared = 0;
        for (const std::uint32_t w : tri) {
          shared +=
              std::ranges::any_of(sides(w), [&](const auto& o) { return o.piece == s.piece; });
        }
        const double fit = glm::dot(s.normal, n);
        if (shared < most_shared || (shared == most_shared && fit <= most)) continue;
        most_shared = shared;
        most = fit;
        best = s.piece;
      }
    }
    return best;
  }

  ExactMesh& mesh_;
  const ImplicitFunction& f_;
  const RunContext& context_;
};

}  // namespace

std::optional<Meeting> find_crease(const ExactMesh& mesh, const ImplicitFunction& f,
                                   const ImplicitFunction& i, const ImplicitFunction& j, Vec3 p,
                                   double reach) {
  const Vec3 m = side(i, p).normal, n = side(j, p).normal;
  if (&i == &j || glm::dot(m, n) > kSmooth) return std::nullopt;
  const std::array<const ImplicitFunction*, 2> both{&i, &j};
  const auto q = onto_all(both, p, reach, mesh.accuracy);
  if (!q) return std::nullopt;
  Meeting c{*q, {{side(i, *q), side(j, *q)}}};
  if (glm::dot(c.sides.sides[0].normal, c.sides.sides[1].normal) > kSmooth) return std::nullopt;
  if (on_surface(mesh, f, *q)) return c;
  // A third piece covers it.
  return find_corner(mesh, f, i, j, f.piece_function(*q), *q, reach);
}

std::optional<Meeting> find_corner(const ExactMesh& mesh, const ImplicitFunction& f,
                                   const ImplicitFunction& i, const ImplicitFunction& j,
                                   const ImplicitFunction& k, Vec3 p, double reach) {
  if (&i == &j || &i == &k || &j == &k) return std::nullopt;
  const std::array<const ImplicitFunction*, 3> all{&i, &j, &k};
  const auto q = onto_all(all, p, reach, mesh.accuracy);
  if (!q || !on_surface(mesh, f, *q)) return std::nullopt;
  const Meeting c{*q, {{side(i, *q), side(j, *q), side(k, *q)}}};
  const auto& s = c.sides.sides;
  for (std::size_t a = 0; a < 3; ++a) {
    if (glm::dot(s[a].normal, s[(a + 1) % 3].normal) > kSmooth) return std::nullopt;
  }
  return c;
}

void cut_along_creases(ExactMesh& mesh, const ImplicitFunction& f, const RunContext& context) {
  if (f.has_pieces()) CreaseCutter(mesh, f, context).cut();
}

}  // namespace burin
