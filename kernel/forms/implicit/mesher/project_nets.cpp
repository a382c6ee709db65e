// Dual vertices moved onto the surface and its creases.

#include <burin/base/bracketed_zero.h>
#include <burin/base/disjoint_sets.h>
#include <burin/base/parallel.h>

#include "../function/project.h"
#include "exact_mesh.h"
#include "tips.h"

#include <array>
#include <cmath>
#include <optional>

namespace burin {
namespace {

constexpr std::size_t kVertexGrain = 1024;
// Steps of the grid that Newton may move a vertex. Beside sharp edges it would go from piece to
// piece and away.
constexpr double kNewtonReach = 0.8;
// Pieces in a cell that are looked at: more than meet at a corner are noise.
constexpr std::size_t kMostPieces = 5;
// Nanoseconds an operation of the function for a vertex that Newton does not place: some ten values
// on each of four edges, and the creases between the pieces there.
constexpr double kPlacing = 400;

// Newton for a range of vertices at once; those that fail are left for `bisect`.
void newton(const ImplicitFunction& f, std::span<Vec3> positions, std::span<Vec3> normals,
            double reach, double accuracy, std::vector<std::uint8_t>& done) {
  constexpr int kSteps = 8;
  const std::size_t n = positions.size();
  std::vector<Vec3> p(positions.begin(), positions.end());
  std::vector<std::uint32_t> active(n);
  for (std::uint32_t i = 0; i < n; ++i) active[i] = i;
  std::vector<Gradient1> g;
  done.assign(n, 0);
  for (int step = 0; step < kSteps && !active.empty(); ++step) {
    g.resize(p.size());
    f.gradients(p, g);
    std::vector<std::uint32_t> next;
    std::vector<Vec3> next_p;
    for (std::size_t k = 0; k < active.size(); ++k) {
      const std::uint32_t i = active[k];
      if (done[i]) {  // moved to its place before: this was for the normal
        positions[i] = p[k];
        normals[i] = normalize_or(g[k].gradient, Vec3(0));
        continue;
      }
      if (!usable(g[k].gradient) || !std::isfinite(g[k].value)) continue;
      const Vec3 d = -g[k].value / glm::dot(g[k].gradient, g[k].gradient) * g[k].gradient;
      const Vec3 to = p[k] + d;
      if (!(glm::distance(to, positions[i]) <= reach)) continue;
      done[i] = glm::length(d) <= accuracy;
      next.push_back(i);
      next_p.push_back(to);
    }
    active = std::move(next);
    p = std::move(next_p);
  }
  for (const std::uint32_t i : active) done[i] = 0;
}

// The change of sign between two points.
Vec3 crossing(const ImplicitFunction& f, Vec3 inside, Vec3 outside, double accuracy) {
  const Vec3 d = outside - inside;
  const auto value = [&](double share) {
    const double v = f.value(inside + share * d);
    return std::isnan(v) ? 1 : v;  // outside
  };
  const double enough = accuracy / glm::length(d);
  return inside + bracketed_zero(value, value(0), value(1), {enough, 0}) * d;
}

class Projector {
 public:
  Projector(ExactMesh& mesh, const ImplicitFunction& f, const Nets& nets, const GridLayout& layout,
            const RunContext& context)
      : mesh_(mesh), f_(f), nets_(nets), layout_(layout), context_(context) {}

  std::size_t run() {
    const std::size_t n = mesh_.positions.size();
    const double cost = f_.cost();
    // Four gradients and the name of the piece; nets and triangles.
    const double each = (4 * work::kGradient + work::kPiece) * cost + 500;
    mesh_.budget.spend(static_cast<double>(n), each);
    state_.assign(n, Good);
    parallel_for(
        n, work::grain(each, kVertexGrain),
        [&](std::size_t begin, std::size_t end) { project(begin, end); }, &context_);
    mark();
    // A vertex that turns out to lie on another piece makes its neighbours doubtful.
    constexpr int kRounds = 4;
    std::size_t strays = 0;
    for (int round = 0; round < kRounds; ++round) {
      std::vector<std::uint32_t> again;
      for (std::uint32_t v = 0; v < n; ++v) {
        if (state_[v] == Marked || state_[v] == Lost) again.push_back(v);
      }
      if (again.empty()) break;
      mesh_.budget.spend(static_cast<double>(again.size()), kPlacing * cost);
      std::vector<Placed> placed(again.size());
      parallel_for(
          again.size(), work::grain(kPlacing * cost, 64),
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) placed[i] = place(again[i]);
          },
          &context_);
      for (std::size_t i = 0; i < again.size(); ++i) strays += settle(again[i], placed[i]);
      spread();
    }
    return strays;
  }

 private:
  enum State : std::uint8_t { Good, Marked, Lost, Settled, Moved };
  struct Placed {
    Meeting crease;  // without sides: a point of the surface
    bool kept = true, stray = false;
  };

  void project(std::size_t begin, std::size_t end) {
    std::vector<std::uint8_t> done;
    newton(f_, std::span(mesh_.positions).subspan(begin, end - begin),
           std::span(mesh_.normals).subspan(begin, end - begin), kNewtonReach * layout_.step,
           mesh_.accuracy, done);
    for (std::size_t i = begin; i < end; ++i) {
      if (!done[i - begin]) state_[i] = Lost;
      mesh_.pieces[i] = f_.piece(mesh_.positions[i]);
    }
  }

  void mark() {
    if (!f_.has_pieces()) return;
    for (std::size_t k = 0; k + 1 < nets_.first_corner.size(); ++k) {
      const std::uint32_t first = nets_.first_corner[k], last = nets_.first_corner[k + 1];
      for (std::uint32_t i = first; i < last; ++i) {
        for (std::uint32_t j = first; j < i; ++j) {
          const std::uint32_t u = nets_.corners[i], v = nets_.corners[j];
          if (mesh_.pieces[u] == mesh_.pieces[v]) continue;
          if (glm::dot(mesh_.normals[u], mesh_.normals[v]) > kSmooth) continue;
          for (const std::uint32_t w : {u, v}) {
            if (state_[w] == Good) state_[w] = Marked;
          }
        }
      }
    }
  }

  // Marks the neighbours of moved vertices.
  void spread() {
    for (std::size_t k = 0; k + 1 < nets_.first_corner.size(); ++k) {
      const auto ring =
          std::span(nets_.corners)
              .subspan(nets_.first_corner[k], nets_.first_corner[k + 1] - nets_.first_corner[k]);
      if (std::ranges::none_of(ring, [&](std::uint32_t v) { return state_[v] == Moved; })) continue;
      for (const std::uint32_t v : ring) {
        if (state_[v] == Good) state_[v] = Marked;
      }
    }
    for (State& s : state_) {
      if (s == Moved) s = Settled;
    }
  }

  bool on_surface(Vec3 p) const {
    const Gradient1 g = f_.gradient(p);
    const double slope = glm::length(g.gradient);
    return slope > 0 && std::abs(g.value) <= 1e-9 * mesh_.size * slope;
  }

  // By the pieces that are active where the sheet crosses the grid: the nearest piece to a vertex
  // inside a thin wedge may be the one of its other face.
  Placed place(std::uint32_t v) const {
    Placed out;
    std::vector<const ImplicitFunction*> pieces;
    Vec3 middle(0), nearest = mesh_.positions[v];
    double least = std::numeric_limits<double>::infinity();
    const auto edges = crossed_edges(layout_, nets_.sources[v]);
    for (const auto& [inside, outside] : edges) {
      const Vec3 at = crossing(f_, inside, outside, mesh_.accuracy);
      middle += at / static_cast<double>(edges.size());
      if (pieces.size() < kMostPieces) {
        const ImplicitFunction* piece = &f_.piece_function(at);
        if (std::ranges::find(pieces, piece) == pieces.end()) pieces.push_back(piece);
      }
      const double d = glm::distance(at, mesh_.positions[v]);
      if (d < least) {
        least = d;
        nearest = at;
      }
    }
    if (auto crease = sharp_place(pieces, middle)) {
      out.crease = std::move(*crease);
      out.kept = false;
      return out;
    }
    for (const ImplicitFunction* piece : pieces) {
      const auto q = onto_surface(*piece, middle, layout_.step, mesh_.accuracy);
      if (!q || !on_surface(*q)) continue;
      // Next to a smooth change of pieces the other one may be active by a hair.
      out.crease.position = onto_surface(f_, *q, layout_.step, mesh_.accuracy).value_or(*q);
      out.kept = false;
      return out;
    }
    if (state_[v] == Lost) {
      out.crease.position = nearest;
      out.kept = false;
      out.stray = !on_surface(nearest);
    }
    return out;
  }

  std::optional<Meeting> sharp_place(const std::vector<const ImplicitFunction*>& pieces,
                                     Vec3 middle) const {
    const double reach = layout_.step;
    std::optional<Meeting> best;
    double least = std::numeric_limits<double>::infinity();
    const auto offer = [&](std::optional<Meeting> m) {
      if (!m) return;
      const double d = glm::distance(m->position, middle);
      if (d >= least) return;
      least = d;
      best = std::move(m);
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          offer(find_corner(mesh_, f_, *pieces[i], *pieces[j], *pieces[k], middle, reach));
        }
      }
    }
    if (best) return best;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        offer(find_crease(mesh_, f_, *pieces[i], *pieces[j], middle, reach));
      }
    }
    return best;
  }

  bool settle(std::uint32_t v, Placed& placed) {
    const bool lost = state_[v] == Lost;
    state_[v] = Settled;
    if (placed.kept) return lost;
    const std::uint64_t before = mesh_.pieces[v];
    const Vec3 p = mesh_.positions[v] = placed.crease.position;
    mesh_.pieces[v] = f_.piece(p);
    mesh_.normals[v] = normalize_or(f_.gradient(p).gradient, Vec3(0));
    if (!placed.crease.sides.sides.empty()) {
      mesh_.crease[v] = static_cast<std::int32_t>(mesh_.creases.size());
      mesh_.creases.push_back(std::move(placed.crease.sides));
    }
    if (mesh_.on_crease(v) || mesh_.pieces[v] != before) state_[v] = Moved;
    return placed.stray;
  }

  ExactMesh& mesh_;
  const ImplicitFunction& f_;
  const Nets& nets_;
  const GridLayout& layout_;
  const RunContext& context_;
  std::vector<State> state_;
};

void triangulate(ExactMesh& mesh, const Nets& nets) {
  for (std::size_t k = 0; k + 1 < nets.first_corner.size(); ++k) {
    const std::uint32_t first = nets.first_corner[k], count = nets.first_corner[k + 1] - first;
    const std::uint32_t* c = nets.corners.data() + first;
    const auto gap = [&](std::uint32_t i, std::uint32_t j) {
      const Vec3 d = mesh.positions[c[i]] - mesh.positions[c[j]];
      return glm::dot(d, d);
    };
    std::uint32_t start = 0;
    if (count == 4) {
      // Along the crease where it passes through two opposite vertices (a third one on it would
      // make a triangle without height), else the shorter way.
      const bool even = mesh.on_crease(c[0]) && mesh.on_crease(c[2]),
                 odd = mesh.on_crease(c[1]) && mesh.on_crease(c[3]);
      const int on =
          mesh.on_crease(c[0]) + mesh.on_crease(c[1]) + mesh.on_crease(c[2]) + mesh.on_crease(c[3]);
      start = even != odd ? odd != (on == 3) : gap(1, 3) < gap(0, 2);
    }
    // From the vertex on a face, if there is one: no diagonal may join the cells beside it again.
    for (std::uint32_t i = 0; count > 4 && i < count; ++i) {
      if (c[i] >= nets.first_extra) start = i;
    }
    for (std::uint32_t i = 1; i + 1 < count; ++i) {
      mesh.triangles.push_back({c[start], c[(start + i) % count], c[(start + i + 1) % count]});
    }
  }
}

// Single samples that a thin wedge lets through between the others make cubes about one grid
// corner, which lie in the wedge that is there already. They are far smaller than what a grid can
// find.
void drop_chips(ExactMesh& mesh) {
  constexpr double kSmallest = 0.5;  // steps
  DisjointSets parts(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    parts.join(t[0], t[1]);
    parts.join(t[0], t[2]);
  }
  std::vector<Box3> boxes(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) boxes[parts.find(v)].add(mesh.positions[v]);
  }
  const auto chip = [&](const Triangle& t) {
    return boxes[parts.find(t[0])].diagonal() < kSmallest * mesh.step;
  };
  if (std::ranges::all_of(mesh.triangles, chip)) return;
  std::erase_if(mesh.triangles, chip);
  for (const Box3& b : boxes) {
    if (!b.empty() && b.diagonal() < kSmallest * mesh.step) mesh.chips.push_back(b);
  }
}

}  // namespace

ExactMesh project_nets(const ImplicitFunction& f, Nets nets, const GridLayout& layout, double size,
                       const WorkBudget& budget, std::size_t& stray, const RunContext& context) {
  ExactMesh mesh;
  mesh.budget = budget;
  mesh.step = layout.step;
  mesh.size = size;
  mesh.positions = std::move(nets.vertices);
  const std::size_t n = mesh.positions.size();
  double far = 0;
  for (const Vec3& p : mesh.positions) far = std::max(far, glm::length(p));
  // Rounding of coordinates far from the origin ends Newton before its own accuracy does.
  mesh.accuracy = 1e-11 * size + 1e-15 * far;
  mesh.normals.resize(n);
  mesh.pieces.resize(n);
  mesh.crease.assign(n, -1);
  mesh.zero.assign(n, 0);
  stray += Projector(mesh, f, nets, layout, context).run();
  triangulate(mesh, nets);
  if (f.has_pieces()) drop_chips(mesh);
  place_tips(mesh, f, nets);
  mesh.side.assign(mesh.triangles.size(), nullptr);
  return mesh;
}

}  // namespace burin
