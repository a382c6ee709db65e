#include "make_manifold.h"

#include <burin/base/disjoint_sets.h>
#include <burin/base/groups.h>

#include "chart_mesh_builder.h"

#include <algorithm>
#include <array>

namespace burin {
namespace {

using Half = std::int32_t;
constexpr Half kNoHalf = -1;

Half next(Half h) { return h % 3 == 2 ? h - 2 : h + 1; }

class Manifold {
 public:
  Manifold(ChartMesh& mesh, const std::vector<std::int32_t>& face_body)
      : mesh_(mesh), body_(face_body), opposite_(3 * mesh.triangles.size(), kNoHalf) {}

  ManifoldPairs run() {
    // Two sheets may touch at a vertex alone, so vertices are split even where all edges pair at
    // once. Split vertices may leave edges with both ends in common with another pair.
    for (int round = 0; round < 2; ++round) {
      const bool paired = pair();
      if (!split_vertices() && paired) break;
      if (round == 1) pair();
    }
    agree_on_borders();
    return {std::move(opposite_), std::move(double_)};
  }

 private:
  std::uint32_t from(Half h) const { return mesh_.triangles[index(h) / 3][index(h) % 3]; }
  std::uint32_t to(Half h) const { return from(next(h)); }
  std::int32_t body(Half h) const { return body_[index(mesh_.face[index(h) / 3])]; }
  std::int32_t edge(Half h) const {
    const std::int32_t b = mesh_.border[index(h)];
    return b < 0 ? -1 : mesh_.borders[index(b)].edge;
  }

  /// Half-edges by the lower of their ends, in order.
  void bucket() {
    sorted_ = grouped(
        mesh_.positions.size(), opposite_.size(),
        [&](std::size_t i) {
          const auto h = static_cast<Half>(i);
          return std::array{std::min(from(h), to(h))};
        },
        [](std::size_t i) { return std::array{static_cast<Half>(i)}; });
  }

  /// Finds the opposite of each half-edge; false where an edge has more triangles than two, or two
  /// turned against each other.
  bool pair() {
    bucket();
    std::ranges::fill(opposite_, kNoHalf);
    double_.clear();
    bool manifold = true;
    for (std::size_t v = 0; v < sorted_.size(); ++v) {
      const auto begin = sorted_.list.begin() + sorted_.first[v],
                 end = sorted_.list.begin() + sorted_.first[v + 1];
      const auto high = [&](Half h) { return std::max(from(h), to(h)); };
      std::sort(begin, end,
                [&](Half a, Half b) { return high(a) != high(b) ? high(a) < high(b) : a < b; });
      for (auto i = begin; i != end;) {
        auto j = i;
        while (j != end && high(*j) == high(*i)) ++j;
        manifold &= pair_group(i, j);
        i = j;
      }
    }
    return manifold;
  }

  template <class It>
  bool pair_group(It begin, It end) {
    const auto n = end - begin;
    if (n == 1) return true;
    if (n == 2 && from(begin[0]) != from(begin[1])) {
      join(begin[0], begin[1]);
      return true;
    }
    // Partners of the same model edge and body first, of the same edge, then any.
    for (int strictness = 2; strictness >= 0; --strictness) {
      for (auto i = begin; i != end; ++i) {
        for (auto j = i + 1; j != end && opposite_[index(*i)] == kNoHalf; ++j) {
          const bool fits =
              opposite_[index(*j)] == kNoHalf && from(*i) != from(*j) && alike(*i, *j, strictness);
          if (fits) join(*i, *j);
        }
      }
    }
    // All but the first of them have to be told apart by vertices of their own.
    for (auto i = begin; i != end; ++i) {
      const Half o = opposite_[index(*i)];
      if (*i != *begin && o != *begin && (o == kNoHalf || *i < o)) double_.push_back(*i);
    }
    return false;
  }

  bool alike(Half a, Half b, int strictness) const {
    if (strictness == 0) return true;
    if (edge(a) != edge(b)) return false;
    if (edge(a) < 0) return mesh_.face[index(a) / 3] == mesh_.face[index(b) / 3];
    return strictness == 1 || body(a) == body(b);
  }

  void join(Half a, Half b) {
    opposite_[index(a)] = b;
    opposite_[index(b)] = a;
  }

  /// One vertex for each fan of triangles that pairs hold together; false where all are so already.
  bool split_vertices() {
    DisjointSets fans(opposite_.size());
    for (Half h = 0; h < static_cast<Half>(opposite_.size()); ++h) {
      const Half o = opposite_[index(h)];
      if (o == kNoHalf) continue;
      fans.join(static_cast<std::uint32_t>(h), static_cast<std::uint32_t>(next(o)));
    }
    std::vector<std::uint8_t> taken(mesh_.positions.size(), 0);
    std::vector<std::uint32_t> vertex(opposite_.size());
    const std::size_t before = mesh_.positions.size();
    for (std::size_t c = 0; c < vertex.size(); ++c) {
      std::uint32_t& v = mesh_.triangles[c / 3][c % 3];
      const std::uint32_t fan = fans.find(static_cast<std::uint32_t>(c));
      if (fan != c) {
        v = vertex[fan];  // fans are named by their first corner
      } else if (taken[v]) {
        mesh_.positions.push_back(Vec3(mesh_.positions[v]));
        v = static_cast<std::uint32_t>(mesh_.positions.size() - 1);
      } else {
        taken[v] = 1;
      }
      vertex[c] = v;
    }
    return mesh_.positions.size() > before;
  }

  /// Where a sliver on an edge shrank to nothing, its neighbour lies on the edge now.
  void agree_on_borders() {
    for (Half h = 0; h < static_cast<Half>(opposite_.size()); ++h) {
      const Half o = opposite_[index(h)];
      if (o == kNoHalf || mesh_.border[index(h)] >= 0 || mesh_.border[index(o)] < 0) continue;
      const ChartMesh::Border b = mesh_.borders[index(mesh_.border[index(o)])];
      mesh_.border[index(h)] = static_cast<std::int32_t>(mesh_.borders.size());
      mesh_.borders.push_back({b.edge, -1, b.t1, b.t0});
    }
  }

  ChartMesh& mesh_;
  const std::vector<std::int32_t>& body_;
  std::vector<Half> opposite_, double_;
  Groups<Half> sorted_;
};

}  // namespace

ManifoldPairs make_manifold(ChartMesh& mesh, const std::vector<std::int32_t>& face_body) {
  return Manifold(mesh, face_body).run();
}

}  // namespace burin
