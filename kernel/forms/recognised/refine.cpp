#include "refine.h"

#include <burin/work_mesh/division.h>

#include "halves.h"
#include "meet.h"
#include "standing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace burin::recognised {
namespace {

constexpr double kTurnOfEdge = 0.21;  // 12 degrees between the normals at both ends of an edge
constexpr int kRounds = 8;
constexpr std::size_t kMostTriangles = 20'000'000;
// How often what turned over is taken back.
constexpr int kPasses = 4;

using Pair = std::pair<std::uint32_t, std::uint32_t>;
Pair ordered(std::uint32_t a, std::uint32_t b) { return a < b ? Pair{a, b} : Pair{b, a}; }

/// An edge once, with one half-edge of each side.
struct SplitEdge {
  Pair ends;
  HalfEdge one = kNoHalfEdge, other = kNoHalfEdge;
  bool split = false;
  Vec3 middle{0};
  KnownPlace place;
  std::uint32_t vertex = 0;
};

class Refiner {
 public:
  Refiner(FacetMesh& mesh, const Recognised& round, const Facets& facets, double tolerance,
          const RunContext& context)
      : m_(mesh),
        round_(round),
        facets_(facets),
        meet_(round, facets),
        halves_(mesh, round, meet_),
        tolerance_(tolerance),
        context_(context) {}

  void run() {
    move_corners();
    settle_flat();
    for (int i = 0; i < kRounds && m_.mesh.triangles.size() < kMostTriangles; ++i) {
      if (!split_once()) break;
    }
  }

 private:
  SurfaceRef ref_of(std::uint32_t t) const { return m_.patch[t] >= 0 ? m_.patch[t] : ~m_.facet[t]; }
  std::int32_t chain_of(SurfaceRef r) const {
    return r < 0 ? -1 : round_.patches[static_cast<std::size_t>(r)].chain;
  }
  /// Those of a smooth chain are one.
  bool is_one(SurfaceRef a, SurfaceRef b) const {
    return a == b || (chain_of(a) >= 0 && chain_of(a) == chain_of(b));
  }
  void add(std::vector<SurfaceRef>& refs, SurfaceRef r) const {
    const auto known = std::ranges::find_if(refs, [&](SurfaceRef k) { return is_one(k, r); });
    if (known == refs.end()) {
      refs.push_back(r);
    } else {
      *known = std::min(*known, r);
    }
  }

  /// Whether a triangle faces as its surface does; those as thin as the noise always do.
  bool upright(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& normal) const {
    const double longest = std::sqrt(
        std::max({glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c)}));
    return glm::dot(glm::cross(b - a, c - a), normal) > -facets_.noise * longest;
  }

  void move_corners() {
    std::vector<std::vector<SurfaceRef>> refs(m_.mesh.positions.size());
    for (std::uint32_t t = 0; t < m_.mesh.triangles.size(); ++t) {
      for (const std::uint32_t v : m_.mesh.triangles[t]) add(refs[v], ref_of(t));
    }
    const std::vector<Vec3> before = m_.mesh.positions;
    for (std::size_t v = 0; v < refs.size(); ++v) {
      if (v % 1024 == 0) context_.check();
      const bool round =
          std::any_of(refs[v].begin(), refs[v].end(), [](SurfaceRef r) { return r >= 0; });
      if (round && refs[v].size() > 1) meet_(refs[v], m_.mesh.positions[v]);
    }
    turn_standing(m_, meet_, context_);
    for (int pass = 0; pass < kPasses; ++pass) {
      bool again = false;
      for (std::uint32_t t = 0; t < m_.mesh.triangles.size(); ++t) {
        const Triangle& tri = m_.mesh.triangles[t];
        auto& p = m_.mesh.positions;
        if (p[tri[0]] == before[tri[0]] && p[tri[1]] == before[tri[1]] &&
            p[tri[2]] == before[tri[2]]) {
          continue;
        }
        const Vec3 middle = (p[tri[0]] + p[tri[1]] + p[tri[2]]) / 3.0;
        const Vec3 normal = meet_.normal(ref_of(t), middle);
        if (upright(p[tri[0]], p[tri[1]], p[tri[2]], normal)) continue;
        for (const std::uint32_t v : tri) p[v] = before[v];
        again = true;
      }
      if (!again) break;
    }
  }

  std::size_t origin(std::size_t h) const { return m_.mesh.triangles[h / 3][h % 3]; }
  std::size_t target(std::size_t h) const { return m_.mesh.triangles[h / 3][(h + 1) % 3]; }
  bool is_round(std::size_t t) const { return m_.patch[t] >= 0; }

  /// Edges that no round surface touches stay as they are.
  void settle_flat() {
    const std::size_t n = m_.mesh.triangles.size();
    std::vector<std::uint8_t> at_round(m_.mesh.positions.size(), 0);
    for (std::size_t t = 0; t < n; ++t) {
      if (!is_round(t)) continue;
      for (const std::uint32_t v : m_.mesh.triangles[t]) at_round[v] = 1;
    }
    settled_.resize(3 * n);
    for (std::size_t h = 0; h < 3 * n; ++h) {
      settled_[h] = is_round(h / 3) || (at_round[origin(h)] && at_round[target(h)]) ? 0 : 1;
    }
  }

  /// Those that may still be split.
  std::vector<SplitEdge> find_edges() const {
    std::vector<std::pair<Pair, HalfEdge>> all;
    for (std::size_t h = 0; h < settled_.size(); ++h) {
      if (settled_[h]) continue;
      const auto a = static_cast<std::uint32_t>(origin(h)),
                 b = static_cast<std::uint32_t>(target(h));
      all.push_back({ordered(a, b), static_cast<HalfEdge>(h)});
    }
    std::sort(all.begin(), all.end());
    std::vector<SplitEdge> edges;
    edges.reserve(all.size() / 2);
    // Solids that only touch along an edge have vertices of their own: two half-edges at the most.
    for (std::size_t i = 0; i < all.size(); ++i) {
      SplitEdge e;
      e.ends = all[i].first;
      e.one = all[i].second;
      if (i + 1 < all.size() && all[i + 1].first == e.ends) e.other = all[++i].second;
      edges.push_back(e);
    }
    return edges;
  }

  void settle(const SplitEdge& e) {
    settled_[static_cast<std::size_t>(e.one)] = 1;
    if (e.other != kNoHalfEdge) settled_[static_cast<std::size_t>(e.other)] = 1;
  }

  /// The surfaces on both sides of an edge, and how many they are.
  std::size_t surfaces_at(const SplitEdge& e, std::array<SurfaceRef, 2>& both) const {
    if (e.other == kNoHalfEdge) return 1;
    both[1] = ref_of(face_of(e.other));
    if (!is_one(both[0], both[1])) return 2;
    both[0] = std::min(both[0], both[1]);
    return 1;
  }

  Vec3 chord_of(const SplitEdge& e) const {
    return 0.5 * (m_.mesh.positions[e.ends.first] + m_.mesh.positions[e.ends.second]);
  }

  /// Whether the middle of an edge is off its surfaces; it is put there.
  void look_at(SplitEdge& e) const {
    std::array<SurfaceRef, 2> both{ref_of(face_of(e.one)), -1};
    const std::span<const SurfaceRef> refs(both.data(), surfaces_at(e, both));
    const SurfaceRef round = *std::ranges::max_element(refs);
    if (round < 0) return;
    const bool within =
        e.other != kNoHalfEdge && ref_of(face_of(e.one)) == ref_of(face_of(e.other));
    const auto middle = halves_.find(e.ends, refs, round, within);
    if (!middle) return;
    e.middle = middle->at;
    e.place = middle->place;
    const Vec3 chord = chord_of(e);
    const double off = glm::length(e.middle - chord);
    if (off <= 4 * facets_.noise && off <= tolerance_) return;
    e.split = off > tolerance_ ||
              glm::dot(halves_.normal_at(round, e.ends.first),
                       halves_.normal_at(round, e.ends.second)) < std::cos(kTurnOfEdge);
  }

  bool split_once() {
    std::vector<SplitEdge> edges = find_edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (i % 1024 == 0) context_.check();
      SplitEdge& e = edges[i];
      look_at(e);
      // What it lies on stays the same, so the answer does; but for what borders take along.
      if (!e.split && !is_inner(e)) settle(e);
    }
    edge_of_.assign(3 * m_.mesh.triangles.size(), -1);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      edge_of_[static_cast<std::size_t>(edges[i].one)] = static_cast<std::int32_t>(i);
      if (edges[i].other < 0) continue;
      edge_of_[static_cast<std::size_t>(edges[i].other)] = static_cast<std::int32_t>(i);
    }
    take_along(edges);
    take_back(edges);
    settle_far(edges);
    bool any = false;
    for (SplitEdge& e : edges) {
      if (!e.split) continue;
      any = true;
      e.vertex = static_cast<std::uint32_t>(m_.mesh.positions.size());
      m_.mesh.positions.push_back(e.middle);
      halves_.keep_last(e.place);
    }
    if (any) rebuild(edges);
    return any;
  }

  /// Whether both sides of an edge are one flat facet.
  bool is_inner(const SplitEdge& e) const {
    return e.other != kNoHalfEdge && !is_round(face_of(e.one)) &&
           ref_of(face_of(e.one)) == ref_of(face_of(e.other));
  }

  /// Edges within flat facets whose border has ceased to move beside them.
  void settle_far(const std::vector<SplitEdge>& edges) {
    for (const SplitEdge& e : edges) {
      if (!e.split && is_inner(e) && mean_move(e, edges) == Vec3(0)) settle(e);
    }
  }

  /// Where the border of a flat facet would move over an edge within it that edge moves too, by the
  /// mean of what it lies between: rings may be narrower than the sagitta of their circles, as
  /// where solids overlap by a thousandth of a mm.
  void take_along(std::vector<SplitEdge>& edges) {
    for (int pass = 0; pass < kPasses; ++pass) {
      std::vector<SplitEdge*> along;
      for (std::uint32_t t = 0; t < m_.mesh.triangles.size(); ++t) {
        if (is_round(t) || pieces_upright(t, edges)) continue;
        for (std::size_t h = 3 * std::size_t{t}; h < 3 * std::size_t{t} + 3; ++h) {
          if (edge_of_[h] < 0 || is_split(h, edges) || !is_crossed(h, edges)) continue;
          SplitEdge& e = edges[static_cast<std::size_t>(edge_of_[h])];
          if (is_inner(e)) along.push_back(&e);
        }
      }
      if (along.empty()) break;
      for (SplitEdge* e : along) e->middle = chord_of(*e) + mean_move(*e, edges);
      for (SplitEdge* e : along) e->split = true;
    }
  }

  /// Whether the middle of another side of the triangle moves over this one.
  bool is_crossed(std::size_t h, const std::vector<SplitEdge>& edges) const {
    const Vec3 a = m_.mesh.positions[origin(h)], along = m_.mesh.positions[target(h)] - a;
    const Vec3 up = meet_.normal(ref_of(face_of(static_cast<HalfEdge>(h))), a);
    for (std::size_t first = h - h % 3, k = first; k < first + 3; ++k) {
      if (!is_split(k, edges)) continue;
      const Vec3 middle = edges[static_cast<std::size_t>(edge_of_[k])].middle;
      if (glm::dot(middle - a, glm::cross(up, along)) <= 0) return true;
    }
    return false;
  }

  /// Of the sides that are split of both triangles at an edge.
  Vec3 mean_move(const SplitEdge& edge, const std::vector<SplitEdge>& edges) const {
    Vec3 sum(0);
    double count = 0;
    for (const HalfEdge side : {edge.one, edge.other}) {
      for (std::size_t first = 3 * std::size_t{face_of(side)}, h = first; h < first + 3; ++h) {
        if (!is_split(h, edges)) continue;
        const SplitEdge& e = edges[static_cast<std::size_t>(edge_of_[h])];
        sum += e.middle - chord_of(e), ++count;
      }
    }
    return count > 0 ? sum / count : sum;
  }

  /// Edges at triangles that would turn over stay as they are.
  void take_back(std::vector<SplitEdge>& edges) {
    for (int pass = 0; pass < kPasses; ++pass) {
      bool again = false;
      for (std::uint32_t t = 0; t < m_.mesh.triangles.size(); ++t) {
        if (pieces_upright(t, edges)) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          if (!is_split(3 * std::size_t{t} + k, edges)) continue;
          SplitEdge& e = edges[static_cast<std::size_t>(edge_of_[3 * std::size_t{t} + k])];
          e.split = false;
          settle(e);
          again = true;
        }
      }
      if (!again) break;
    }
  }

  /// The corners of a triangle and the middles of its sides; the pieces that it falls into.
  Division pieces(std::uint32_t t, const std::vector<SplitEdge>& edges,
                  std::array<Vec3, 6>& p) const {
    std::uint8_t marks = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t h = 3 * std::size_t{t} + k;
      p[k] = m_.mesh.positions[m_.mesh.triangles[t][k]];
      if (!is_split(h, edges)) continue;
      p[k + 3] = edges[static_cast<std::size_t>(edge_of_[h])].middle;
      marks |= static_cast<std::uint8_t>(1U << k);
    }
    return divide(marks, p);
  }

  bool is_split(std::size_t h, const std::vector<SplitEdge>& edges) const {
    return edge_of_[h] >= 0 && edges[static_cast<std::size_t>(edge_of_[h])].split;
  }

  bool pieces_upright(std::uint32_t t, const std::vector<SplitEdge>& edges) const {
    std::array<Vec3, 6> p;
    const Division division = pieces(t, edges, p);
    if (division.count == 1) return true;
    const SurfaceRef ref = ref_of(t);
    const bool on_sheet = ref >= 0 && round_.patches[static_cast<std::size_t>(ref)].sheet;
    std::array<Vec3, 6> normal{};
    if (on_sheet) normal = normals_on_sheet(t, ref, edges, p);
    return std::ranges::all_of(division, [&](const Division::Piece& piece) {
      const Vec3 &a = p[piece[0]], &b = p[piece[1]], &c = p[piece[2]];
      const Vec3 there = on_sheet ? normal[piece[0]] + normal[piece[1]] + normal[piece[2]]
                                  : meet_.normal(ref, (a + b + c) / 3.0);
      return upright(a, b, c, there);
    });
  }

  /// At the corners of a triangle and the middles of its sides: they are known, and a place within
  /// would have to be searched.
  std::array<Vec3, 6> normals_on_sheet(std::uint32_t t, SurfaceRef ref,
                                       const std::vector<SplitEdge>& edges,
                                       const std::array<Vec3, 6>& p) const {
    std::array<Vec3, 6> normal{};
    for (std::size_t k = 0; k < 3; ++k) {
      normal[k] = halves_.normal_at(ref, m_.mesh.triangles[t][k]) / 3.0;
      const std::size_t h = 3 * std::size_t{t} + k;
      if (!is_split(h, edges)) continue;
      const KnownPlace& place = edges[static_cast<std::size_t>(edge_of_[h])].place;
      normal[k + 3] = (place.of == ref ? place.normal : meet_.normal(ref, p[k + 3])) / 3.0;
    }
    return normal;
  }

  void rebuild(const std::vector<SplitEdge>& edges) {
    FacetMesh out;
    out.mesh.positions = std::move(m_.mesh.positions);
    m_.mesh.positions = out.mesh.positions;
    std::vector<std::uint8_t> settled;
    for (std::uint32_t t = 0; t < m_.mesh.triangles.size(); ++t) {
      if (t % 4096 == 0) context_.check();
      std::array<Vec3, 6> p;
      std::array<std::uint32_t, 6> vertex{};
      std::array<Vec3, 6> normal{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t h = 3 * std::size_t{t} + k, next = 3 * std::size_t{t} + (k + 1) % 3;
        vertex[k] = m_.mesh.triangles[t][k];
        if (is_split(h, edges)) vertex[k + 3] = edges[static_cast<std::size_t>(edge_of_[h])].vertex;
        normal[k] = m_.normal[h];
        const Vec3 sum = m_.normal[h] + m_.normal[next];
        normal[k + 3] = glm::length(sum) > 0 ? glm::normalize(sum) : m_.normal[h];
      }
      for (const Division::Piece& piece : pieces(t, edges, p)) {
        std::int32_t record[3];
        Vec3 normals[3];
        Triangle tri{};
        for (std::size_t k = 0; k < 3; ++k) {
          tri[k] = vertex[piece[k]];
          normals[k] = normal[piece[k]];
          const std::uint8_t from = piece[k], to = piece[(k + 1) % 3];
          const int side = side_of(from, to);
          const std::size_t h = 3 * std::size_t{t} + static_cast<std::size_t>(std::max(side, 0));
          record[k] = side < 0 ? -1 : m_.edge[h];
          const bool whole = side >= 0 && from < 3 && to < 3;
          settled.push_back(whole ? settled_[h] : 0);
        }
        out.add(tri, t, record, normals, m_);
      }
    }
    m_ = std::move(out);
    settled_ = std::move(settled);
  }

  FacetMesh& m_;
  const Recognised& round_;
  const Facets& facets_;
  Meeting meet_;
  Halves halves_;
  double tolerance_;
  const RunContext& context_;
  /// For each half-edge whether it stays as it is.
  std::vector<std::uint8_t> settled_;
  std::vector<std::int32_t> edge_of_;
};

}  // namespace

void refine(FacetMesh& mesh, const Recognised& round, const Facets& facets, double tolerance,
            const RunContext& context) {
  Refiner(mesh, round, facets, tolerance, context).run();
}

}  // namespace burin::recognised
