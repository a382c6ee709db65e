#include "view_cut.h"

#include <burin/base/bracketed_zero.h>
#include <burin/base/parallel.h>
#include <burin/camera/facing.h>

#include "../function/project.h"

#include <array>
#include <cmath>
#include <optional>
#include <tuple>

namespace burin {
namespace {

constexpr int kPasses = 4;
constexpr int kHalvings = 3;
constexpr double kSnap = 0.2;  // steps of the grid

// A half-edge of triangle t along which something is to be done.
struct Place {
  std::uint32_t low = 0, high = 0, face = 0, corner = 0;
  auto order() const { return std::tuple(low, high, face); }
  bool same_edge(const Place& o) const { return low == o.low && high == o.high; }
};

struct NewPoint {
  Vec3 position{0};
  CreaseVertex sides;  // one: inside a smooth region; two: on a crease
};

class ContourCutter {
 public:
  ContourCutter(ExactMesh& mesh, const ImplicitFunction& f, const Camera& camera,
                const RunContext& context)
      : mesh_(mesh), f_(f), camera_(camera), facing_(camera), context_(context) {}

  void cut(double chord) {
    snap();
    for (int pass = 0; pass < kPasses; ++pass) {
      find_values();
      if (!insert(crossed(), [&](const Place& p, const Place* o) { return crossing(p, o); })) break;
    }
    for (int i = 0; i < kHalvings; ++i) {
      find_values();
      if (!insert(contour_edges(),
                  [&](const Place& p, const Place*) { return middle(p, chord); })) {
        break;
      }
    }
    collapse_slivers(mesh_, f_, kSnap, context_);
  }

 private:
  void find_values() {
    g_.resize(mesh_.triangles.size());
    parallel_for(
        g_.size(), 1024,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t t = begin; t < end; ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
              g_[t][k] = mesh_.corner_zero(t, k) ? 0
                                                 : facing_(mesh_.positions[mesh_.triangles[t][k]],
                                                           mesh_.corner_normal(t, k));
            }
          }
        },
        &context_);
  }

  // Half-edges for which `wanted(t, k)`, and the other halves of theirs, in order of the edges.
  template <class Wanted>
  std::vector<Place> places(const Wanted& wanted) const {
    std::vector<Place> found;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        if (!wanted(t, k)) continue;
        const std::uint32_t u = mesh_.triangles[t][k], v = mesh_.triangles[t][(k + 1) % 3];
        found.push_back({std::min(u, v), std::max(u, v), t, k});
      }
    }
    std::ranges::sort(found, {}, &Place::order);
    return found;
  }

  std::vector<Place> crossed() const {
    // Of edges between two crease vertices both halves: one side may change its sign, the other
    // not.
    return places([&](std::uint32_t t, std::uint32_t k) {
      const std::uint32_t l = (k + 1) % 3;
      const Triangle& tri = mesh_.triangles[t];
      return g_[t][k] * g_[t][l] < 0 || (mesh_.on_crease(tri[k]) && mesh_.on_crease(tri[l]));
    });
  }
  bool changes(const Place& p) const {
    return g_[p.face][p.corner] * g_[p.face][(p.corner + 1) % 3] < 0;
  }

  // Edges between zeros with a front and a back side.
  std::vector<Place> contour_edges() const {
    std::vector<Place> both = places(
        [&](std::uint32_t t, std::uint32_t k) { return g_[t][k] == 0 && g_[t][(k + 1) % 3] == 0; });
    std::vector<Place> out;
    for (std::size_t i = 0; i + 1 < both.size(); ++i) {
      if (!both[i].same_edge(both[i + 1])) continue;
      const auto apex = [&](const Place& p) { return g_[p.face][(p.corner + 2) % 3]; };
      if (apex(both[i]) * apex(both[i + 1]) < 0) out.push_back(both[i]);
    }
    return out;
  }

  // Asks `make` for a point for each edge (its half and, where known, the other half) and cuts.
  template <class Make>
  bool insert(const std::vector<Place>& all, const Make& make) {
    std::vector<std::size_t> first;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i == 0 || !all[i].same_edge(all[i - 1])) first.push_back(i);
    }
    std::vector<std::optional<NewPoint>> made(first.size());
    // Some ten trials, each moved onto the surface.
    const double each = 40 * work::kOneValue * work::kGradient * f_.cost();
    mesh_.budget.spend(static_cast<double>(first.size()), each);
    parallel_for(
        first.size(), work::grain(each, 32),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t n = begin; n < end; ++n) {
            const Place& p = all[first[n]];
            const bool two = first[n] + 1 < all.size() && all[first[n] + 1].same_edge(p);
            made[n] = make(p, two ? &all[first[n] + 1] : nullptr);
          }
        },
        &context_);
    EdgePoints points;
    for (std::size_t n = 0; n < first.size(); ++n) {
      if (!made[n]) continue;
      const Place& p = all[first[n]];
      auto& sides = made[n]->sides.sides;
      std::uint32_t v = 0;
      if (sides.size() > 1) {
        v = mesh_.add_crease_vertex(made[n]->position, std::move(made[n]->sides));
      } else {
        v = mesh_.add_vertex(made[n]->position, sides[0].normal, f_.piece(made[n]->position));
        mesh_.zero[v] = 1;
      }
      points.add(p.low, p.high, v);
    }
    if (points.empty()) return false;
    points.sort();
    cut_at_points(mesh_, points, nullptr);
    return true;
  }

  const ImplicitFunction& function_of(std::uint32_t face) const {
    return mesh_.side[face] ? *mesh_.side[face] : f_;
  }
  static Vec3 normal(const ImplicitFunction& f, Vec3 p) {
    return normalize_or(f.gradient(p).gradient, Vec3(0, 0, 1));
  }

  bool sharp(const Place& p, const Place& o) const {
    const std::size_t pk = p.corner, ok = o.corner;
    // The halves run opposite ways.
    const double a =
        glm::dot(mesh_.corner_normal(p.face, pk), mesh_.corner_normal(o.face, (ok + 1) % 3));
    const double b =
        glm::dot(mesh_.corner_normal(p.face, (pk + 1) % 3), mesh_.corner_normal(o.face, ok));
    return std::min(a, b) < kSmooth;
  }

  std::optional<NewPoint> crossing(const Place& first, const Place* other) const {
    const bool crease =
        mesh_.on_crease(first.low) && mesh_.on_crease(first.high) && other && sharp(first, *other);
    const bool swap = !changes(first);
    if (swap && (!other || !changes(*other))) return std::nullopt;
    const Place& p = swap ? *other : first;
    const ImplicitFunction& f = function_of(p.face);
    if (!crease) return zero_along(p, f, nullptr);
    return zero_along(p, f, &function_of(swap ? first.face : other->face));
  }

  // The zero of g of `f` on the edge of p moved onto the surface, or (where there is another side)
  // onto the crease.
  std::optional<NewPoint> zero_along(const Place& p, const ImplicitFunction& f,
                                     const ImplicitFunction* other) const {
    const Vec3 a = mesh_.positions[mesh_.triangles[p.face][p.corner]],
               b = mesh_.positions[mesh_.triangles[p.face][(p.corner + 1) % 3]];
    const double length = glm::distance(a, b);
    const auto at = [&](double share) {
      const Vec3 q = a + share * (b - a);
      if (other) {
        const std::array<const ImplicitFunction*, 3> both{&f, other, nullptr};
        return onto_all(std::span(both).first(2), q, length, mesh_.accuracy).value_or(q);
      }
      return onto_surface(f, q, length, mesh_.accuracy).value_or(q);
    };
    Vec3 best = a;
    double last = 0;
    const auto g = [&](double share) {
      best = at(share);
      last = share;
      return facing_(best, normal(f, best));
    };
    const double zero =
        bracketed_zero(g, g_[p.face][p.corner], g_[p.face][(p.corner + 1) % 3],
                       {mesh_.accuracy / length, 1e-13});  // rounding of unit vectors
    if (last != zero) best = at(zero);
    NewPoint point{best, {{{&f, normal(f, best), true}}}};
    if (other) point.sides.sides.push_back({other, normal(*other, best), false});
    return point;
  }

  // The point of the contour next to `start`: Newton for f = 0 and g = 0.
  std::optional<Vec3> onto_contour(const ImplicitFunction& f, Vec3 start, double reach) const {
    constexpr int kSteps = 12;
    Vec3 q = start;
    for (int i = 0; i < kSteps; ++i) {
      const Gradient2 h = f.hessian(q);
      const double slope = glm::length(h.gradient);
      if (!(slope > 0)) return std::nullopt;
      const Vec3 n = h.gradient / slope;
      // The change of n . v with the place; that of v itself is small (perspective).
      const Vec3 dg = h.hessian_times(reject(facing_.to_viewer(q), n)) / slope;
      const double g = facing_(q, n), s = h.value / slope;
      const double dd = glm::dot(dg, dg), dn = glm::dot(dg, n), det = dd - dn * dn;
      if (!(det > 1e-12 * dd)) return std::nullopt;  // the curve is not determined here
      const Vec3 step = (-s * dd + g * dn) / det * n + (s * dn - g) / det * dg;
      q += step;
      if (!(glm::distance(q, start) < reach)) return std::nullopt;
      if (glm::length(step) < 1e-9 * mesh_.size) return q;
    }
    return std::nullopt;
  }

  // Vertices next to the contour are drawn onto it: cuts beside them would leave slivers.
  void snap() {
    const double each = 4 * work::kHessian * f_.cost();
    mesh_.budget.spend(static_cast<double>(mesh_.positions.size()), each);
    parallel_for(
        mesh_.positions.size(), work::grain(each, 1024),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t v = begin; v < end; ++v) {
            // g changes by less than a radian in a step; creases stay.
            if (mesh_.crease[v] >= 0 || mesh_.zero[v]) continue;
            if (std::abs(facing_(mesh_.positions[v], mesh_.normals[v])) > 0.5) continue;
            const double reach = kSnap * mesh_.step_at(static_cast<std::uint32_t>(v));
            const auto q = onto_contour(f_, mesh_.positions[v], reach);
            if (!q) continue;
            mesh_.positions[v] = *q;
            mesh_.normals[v] = normal(f_, *q);
            mesh_.zero[v] = 1;
          }
        },
        &context_);
  }

  // The contour's own point beside the middle of a chord that is too far from it.
  std::optional<NewPoint> middle(const Place& p, double chord) const {
    if (mesh_.on_crease(p.low) && mesh_.on_crease(p.high)) return std::nullopt;
    const ImplicitFunction& f = function_of(p.face);
    const Vec3 a = mesh_.positions[p.low], b = mesh_.positions[p.high], start = 0.5 * (a + b);
    const double length = glm::distance(a, b);
    const auto q = onto_contour(f, start, 0.25 * length);
    if (!q) return std::nullopt;
    const Vec3 off = reject(*q - start, (b - a) / length);
    if (glm::length(camera_.velocity(start, off)) <= chord) return std::nullopt;
    return NewPoint{*q, {{{&f, normal(f, *q), true}}}};
  }

  ExactMesh& mesh_;
  const ImplicitFunction& f_;
  const Camera& camera_;
  FacingFunction facing_;
  const RunContext& context_;
  std::vector<std::array<double, 3>> g_;
};

}  // namespace

void cut_for_view(ExactMesh& mesh, const ImplicitFunction& f, const Camera& camera, double chord,
                  const RunContext& context) {
  ContourCutter(mesh, f, camera, context).cut(chord);
}

}  // namespace burin
