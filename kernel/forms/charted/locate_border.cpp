// The true curves behind the chords of border half-edges.

#include <burin/base/parallel.h>

#include "locate.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Curve evaluations at the most to find the point of a curve beside a point of its chord; two or
// three do where the parameter runs evenly.
constexpr int kBorderIterations = 20;
// Share of a chord to which the point beside is found.
constexpr double kShareError = 1e-12;
// The bulge is sampled at these shares; between them it can be larger, by a third on an arc.
constexpr double kSamples[] = {0.2, 0.5, 0.8};
constexpr double kBulgeMargin = 1.5;
// Below this share of the chord a curve is straight: rounding.
constexpr double kStraight = 1e-11;

}  // namespace

Vec2 UvTriangles::to_branch(std::uint32_t triangle, Vec2 uv, Vec2 near) const {
  const Vec2 period = period_[static_cast<std::size_t>(face(triangle))];
  for (int i = 0; i < 2; ++i) {
    if (period[i] > 0) uv[i] += period[i] * std::round((near[i] - uv[i]) / period[i]);
  }
  return uv;
}

BorderPlace UvTriangles::place(HalfEdge h, double t) const {
  const ChartMesh::Border& b = border(h);
  const Side s = side(h);
  const double span = b.t1 - b.t0;
  BorderPlace p;
  p.t = t;
  p.share = span != 0 ? std::clamp((t - b.t0) / span, 0.0, 1.0) : 0;
  const Vec2 chord = s.a + p.share * (s.b - s.a);
  p.uv = b.coedge < 0 ? chord : to_branch(face_of(h), atlas_.atlas->on_coedge(b.coedge, t), chord);
  return p;
}

double UvTriangles::share(HalfEdge h, Vec2 uv) const {
  const Side s = side(h);
  const Vec2 e = s.b - s.a;
  const double square = glm::dot(e, e);
  return square > 0 ? glm::dot(uv - s.a, e) / square : 0;
}

double UvTriangles::inside_chord(HalfEdge h, Vec2 uv) const {
  const Side s = side(h);
  const Vec2 e = s.b - s.a;
  return turn(face_of(h)) * cross2(e, uv - s.a) / glm::length(e);
}

BorderPlace UvTriangles::beside(HalfEdge h, Vec2 uv) const {
  const ChartMesh::Border& b = border(h);
  const double wanted = std::clamp(share(h, uv), 0.0, 1.0), span = b.t1 - b.t0;
  BorderPlace result = place(h, b.t0 + wanted * span);
  for (int i = 0; b.coedge >= 0 && i < kBorderIterations; ++i) {
    const double gap = wanted - share(h, result.uv);
    if (std::abs(gap) < kShareError) break;
    const double next = std::clamp(result.share + gap, 0.0, 1.0);
    result = place(h, b.t0 + next * span);
    result.share = next;
  }
  return result;
}

BorderPlace UvTriangles::across(HalfEdge h, const BorderPlace& from) const {
  const HalfEdge o = opposite(h);
  if (!is_border(o)) {
    const Side s = side(o);
    return {1 - from.share, 0, s.b + from.share * (s.a - s.b)};
  }
  const ChartMesh::Border& b = border(o);
  // Without a curve both sides share the chord, run the other way.
  if (b.coedge < 0 || border(h).coedge < 0) {
    return place(o, b.t0 + (1 - from.share) * (b.t1 - b.t0));
  }
  return place(o, from.t);
}

Vec2 UvTriangles::tangent(HalfEdge h, const BorderPlace& at) const {
  const Side s = side(h);
  if (!is_border(h) || bulge(h) == 0) return s.b - s.a;
  const ChartMesh::Border& b = border(h);
  // A small share of the chord each way, on the curve's own side of its ends.
  constexpr double kStep = 1e-4;
  const double low = std::max(at.share - kStep, 0.0), high = std::min(at.share + kStep, 1.0);
  const double span = b.t1 - b.t0;
  return (place(h, b.t0 + high * span).uv - place(h, b.t0 + low * span).uv) / (high - low);
}

void UvTriangles::find_bulges(const RunContext& context) {
  bulge_.assign(mesh_.borders.size(), 0);
  curved_.assign(mesh_.triangles.size(), 0);
  parallel_for(
      mesh_.triangles.size(), 4096,
      [&](std::size_t begin, std::size_t end) {
        for (auto h = static_cast<HalfEdge>(3 * begin); h < static_cast<HalfEdge>(3 * end); ++h) {
          if (!is_border(h) || border(h).coedge < 0) continue;
          const ChartMesh::Border& b = border(h);
          const Side s = side(h);
          double bulge = 0;
          for (const double x : kSamples) {
            const Vec2 c = place(h, b.t0 + x * (b.t1 - b.t0)).uv;
            bulge = std::max(bulge, std::abs(inside_chord(h, c)));
          }
          if (!(bulge > kStraight * glm::length(s.b - s.a))) continue;
          bulge_[static_cast<std::size_t>(mesh_.border[static_cast<std::size_t>(h)])] =
              kBulgeMargin * bulge;
          curved_[face_of(h)] = 1;
        }
      },
      &context);
}

}  // namespace burin::detail
