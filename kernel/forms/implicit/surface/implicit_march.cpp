// Geodesics on f = 0.

#include "../function/project.h"
#include "implicit_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

// Angle in radians that one step may turn: with the fourth order the error of a step is some 1e-9
// of its length.
constexpr double kTurn = 0.1;
// Below this turn the third order, which needs one more Hessian only, will do: it is some 1e-7 of
// the radius of curvature off, and 1e-5 radians.
constexpr double kShortTurn = 0.05;
// Cosine of the angle that the normal may turn over a step although less was expected: 2 kTurn.
constexpr double kMostTurned = 0.98007;
// Steps of one march, and for each edge length of the triangles that it goes: into a cusp or round
// and round on what is far finer than they are it ends with NotConverged.
constexpr double kFirstSteps = 64, kStepsPerEdge = 128;

// How much normals turn a mm, at the most.
double turning(const Gradient2& g, double slope) {
  const double h =
      g.xx * g.xx + g.yy * g.yy + g.zz * g.zz + 2 * (g.xy * g.xy + g.xz * g.xz + g.yz * g.yz);
  return std::sqrt(h) / slope;
}

// The acceleration of a point that runs along a geodesic with velocity t.
Vec3 acceleration(const Gradient2& g, Vec3 t) {
  return -glm::dot(t, g.hessian_times(t)) / glm::dot(g.gradient, g.gradient) * g.gradient;
}

}  // namespace

struct ImplicitSurface::State {
  Vec3 position{0}, tangent{0}, normal{0};
  // Where a step has begun:
  Gradient2 g;
  double slope = 0, turn = 0;
  bool complete = false;

  void set(const Gradient2& derivatives) {
    g = derivatives;
    slope = glm::length(g.gradient);
    normal = usable(g.gradient) ? g.gradient / slope : Vec3(0);
    turn = turning(g, slope);
    complete = true;
  }
};

// One step of `length` from a complete state, which ends on f = 0 with a unit tangent. Of the end
// the gradient alone is found: a Hessian a step, the one where it begins, is enough.
bool ImplicitSurface::advance(const ImplicitFunction& f, const State& from, double length,
                              State& to) const {
  const Vec3 p = from.position, t = from.tangent;
  to.complete = false;
  Vec3 q;
  if (length * from.turn < kShortTurn) {
    // The Taylor series of the geodesic in its Darboux frame.
    const Vec3 n = from.normal, b = glm::cross(n, t), ht = from.g.hessian_times(t);
    const double k = -glm::dot(t, ht) / from.slope, m = -glm::dot(b, ht) / from.slope;
    const double s = length;
    q = p + (s - k * k * s * s * s / 6) * t + 0.5 * k * s * s * n + k * m * s * s * s / 6 * -b;
    const Gradient1 g = f.gradient(q);
    const Vec3 d = -g.value / glm::dot(g.gradient, g.gradient) * g.gradient;
    Vec3 gradient;
    if (glm::dot(d, d) * from.turn <= accuracy_) {
      // One step of Newton is enough, and the gradient goes along with it.
      q += d;
      gradient = g.gradient + from.g.hessian_times(d);
    } else {
      const auto on = onto_surface(f, q, 0.5 * length + accuracy_, accuracy_);
      if (!on) return false;
      q = *on;
      gradient = f.gradient(q).gradient;
    }
    // Carried by the smallest rotation between the normals: symmetric, so of the second order.
    to.position = q;
    to.normal = normalize_or(gradient, Vec3(0));
    to.tangent = normalize_or(reject(transport(t, n, to.normal), to.normal), Vec3(0));
    return to.tangent != Vec3(0) && glm::dot(n, to.normal) > kMostTurned;
  }
  const double h = length;
  const Vec3 a1 = acceleration(from.g, t);
  const Vec3 v2 = t + 0.5 * h * a1;
  const Vec3 a2 = acceleration(f.hessian(p + 0.5 * h * t), v2);
  const Vec3 v3 = t + 0.5 * h * a2;
  const Vec3 a3 = acceleration(f.hessian(p + 0.5 * h * v2), v3);
  const Vec3 v4 = t + h * a3;
  const Vec3 a4 = acceleration(f.hessian(p + h * v3), v4);
  q = p + h / 6 * (t + 2.0 * v2 + 2.0 * v3 + v4);
  const Vec3 v = t + h / 6 * (a1 + 2.0 * a2 + 2.0 * a3 + a4);
  const auto on = onto_surface(f, q, 0.5 * length + accuracy_, accuracy_);
  if (!on) return false;
  to.position = *on;
  to.set(f.hessian(*on));
  to.tangent = normalize_or(reject(v, to.normal), Vec3(0));
  return to.tangent != Vec3(0) && to.turn * length < 2 * kTurn;
}

// Whether a point of a piece's own zero set belongs to the surface and lies on the near side of all
// creases.
bool ImplicitSurface::stays(const ImplicitFunction& piece, std::uint32_t face, Vec3 p) const {
  const double slope = glm::length(piece.gradient(p).gradient);
  return std::abs(function_->value(p)) <= 1e-9 * size_ * slope && walk(face, p).reached;
}

MarchStep ImplicitSurface::march(const SurfacePoint& from, Vec3 tangent, double length) const {
  MarchStep step;
  step.end = from;
  const ImplicitFunction* f = &function_at(from.triangle);
  // Whether it is one piece, which is smooth everywhere, or the whole function near here.
  bool one_piece = side_[from.triangle] != nullptr;
  State at;
  at.position = from.position;
  at.set(known_hessian(*f, at.position));
  const Vec3 n = at.normal;
  const Vec3 flat = reject(tangent, n);
  // A tangent within 1e-9 radians of the normal has no direction in the plane.
  if (n == Vec3(0) || !(glm::length(flat) > 1e-9 * glm::length(tangent))) {
    step.stop = MarchStop::Singular;
    return step;
  }
  at.tangent = glm::normalize(flat);
  std::uint32_t face = from.triangle;
  const auto finish = [&](MarchStop stop, std::optional<ProxyPoint> known = {}) {
    const ProxyPoint place = known ? *known : walk(face, at.position).place;
    step.end = {0, place.bary, at.position, place.face};
    step.direction = at.tangent;
    step.stop = stop;
    return step;
  };
  if (!(length > 0)) return finish(MarchStop::Completed);
  const double most = kFirstSteps + kStepsPerEdge * length / step_;
  for (double i = 0; i < most; ++i) {
    const double rest = length - step.length;
    if (!at.complete) at.set(f->hessian(at.position));
    double s = std::min(rest, (kLocalReach - 1) * step_);
    if (at.turn * s > kTurn) s = kTurn / at.turn;
    State next;
    // Curvature that grows along the way is met by shorter steps.
    bool good = false;
    for (int half = 0; half < 20 && !good; ++half) {
      good = advance(*f, at, s, next);
      if (!good) s *= 0.5;
    }
    if (!good) return finish(at.normal != Vec3(0) ? MarchStop::NotConverged : MarchStop::Singular);
    const Walk way = walk(face, next.position);
    if (way.by_crease && !one_piece && function_->has_pieces()) {
      // Over a crease only a single piece goes on smoothly: the step once more, on it.
      f = &function_->piece_function(at.position);
      one_piece = true;
      at.complete = false;
      continue;
    }
    if (way.by_crease && !stays(*f, face, next.position)) {
      // Another piece has come up: on the way, at an angle or smoothly.
      double low = 0, high = s;
      State good_at = at, probe;
      while (high - low > accuracy_) {
        const double middle = 0.5 * (low + high);
        if (middle <= low || middle >= high) break;
        if (advance(*f, at, middle, probe) && stays(*f, face, probe.position)) {
          low = middle;
          good_at = probe;
        } else {
          high = middle;
        }
      }
      if (!advance(*f, at, high, probe)) probe = good_at;
      const Vec3 here = good_at.normal,
                 there = normalize_or(
                     function_->piece_function(probe.position).gradient(probe.position).gradient,
                     Vec3(0));
      if (glm::dot(here, there) < kSmooth || !walk(face, next.position).reached) {
        step.length += low;
        at = good_at;
        return finish(MarchStop::Crease);
      }
      const auto on = onto_surface(*function_, next.position, step_, accuracy_);
      if (on) next.position = *on;
      f = &function_->piece_function(next.position);
      next.set(f->hessian(next.position));
      next.tangent = normalize_or(reject(next.tangent, next.normal), next.tangent);
    } else if (way.lost && !way.by_crease) {
      // Beyond what the function of the last triangle holds for.
      return finish(MarchStop::NotConverged);
    } else if (!way.by_crease) {
      f = &function_at(way.place.face);
      one_piece = false;
    }
    at = next;
    face = way.place.face;
    if (s >= rest) {
      step.length = length;
      return finish(MarchStop::Completed, way.place);
    }
    step.length += s;
  }
  return finish(MarchStop::NotConverged);
}

}  // namespace burin
