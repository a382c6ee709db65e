#include <burin/drawing/outline.h>

#include "schneider.h"
#include "turned.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// Radians that a stretch curling tighter than half the width may turn before it is cut: its inner
/// side folds back, and by the nonzero rule a fold stays filled up to half a turn.
constexpr double kMaxTightTurn = 1.0;
/// Half widths in mm below which an end is a point: finer than a pen.
constexpr double kPointedEnd = 0.012;
/// Handle of a cubic cap whose middle then lies exactly 1 ahead.
constexpr double kCapHandle = 4.0 / 3.0;
/// Depth of the nose at a stroke's end as a share of half its width. The nose ends where the line
/// does: ink must not pass the crease that a stroke stops at.
constexpr double kNose = 0.8;

/// The centre line with z = half width.
using Centre = std::vector<Vec3>;

Vec2 flat(Vec3 v) { return {v.x, v.y}; }

Centre centre_line(std::span<const Vec2> points, std::span<const double> widths, double tolerance) {
  Centre all;
  all.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 p(points[i], 0.5 * std::max(widths[i], 0.0));
    if (all.empty() || glm::distance(flat(all.back()), points[i]) > 0.01 * tolerance) {
      all.push_back(p);
    }
  }
  Centre out;
  for (const std::size_t i : simplify(all, kSimplifyShare * tolerance)) {
    if (out.empty() || flat(out.back()) != flat(all[i])) out.push_back(all[i]);
  }
  return out;
}

/// Unit tangents at the points of one piece.
std::vector<Vec2> tangents(std::span<const Vec3> c) {
  const std::size_t n = c.size();
  std::vector<Vec2> t(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    t[i] = circle_tangent(flat(c[i - 1]), flat(c[i]), flat(c[i + 1]));
  }
  // The ends as a circle through the last three points has them.
  const auto mirrored = [](Vec2 inner, Vec2 chord) {
    return 2 * glm::dot(inner, chord) * chord - inner;
  };
  const Vec2 first = direction(flat(c[0]), flat(c[1]));
  const Vec2 last = direction(flat(c[n - 2]), flat(c[n - 1]));
  t[0] = n > 2 ? mirrored(t[1], first) : first;
  t[n - 1] = n > 2 ? mirrored(t[n - 2], last) : last;
  return t;
}

/// A round end from one side to the other that reaches `depth` ahead of them.
void append_cap(Vec2 from, Vec2 to, Vec2 ahead, double depth, std::vector<CubicBezier>& chain) {
  if (from == to) return;
  const Vec2 handle = ahead * (kCapHandle * depth);
  chain.push_back({from, from + handle, to + handle, to});
}

/// Takes `depth` off the end of a line, but leaves some of it.
void shorten(Centre& c, double depth) {
  while (c.size() > 2 && depth > 0) {
    const double l = glm::distance(flat(c.back()), flat(c[c.size() - 2]));
    if (l > depth) break;
    depth -= l;
    c.pop_back();
  }
  const Vec3 before = c[c.size() - 2];
  const double l = glm::distance(flat(c.back()), flat(before));
  c.back() = glm::mix(c.back(), before, std::min(depth / l, 0.5));
}

/// Makes room for a nose at the end of the line; its depth.
double shorten_for_nose(Centre& c) {
  if (c.back().z <= kPointedEnd) return 0;
  const Vec2 tip = flat(c.back());
  shorten(c, kNose * c.back().z);
  return glm::distance(tip, flat(c.back()));
}

/// The closed chain round one piece: along its left side, back along its right side.
std::vector<CubicBezier> piece_outline(std::span<const Vec3> c, double start_depth,
                                       double end_depth, double tolerance) {
  const std::size_t n = c.size();
  const std::vector<Vec2> t = tangents(c);
  std::vector<Vec2> there(n), back(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool tip = (i == 0 || i + 1 == n) && c[i].z <= kPointedEnd;
    const Vec2 side = turned_left(t[i]) * (tip ? 0.0 : c[i].z);
    there[i] = flat(c[i]) + side;
    back[n - 1 - i] = flat(c[i]) - side;
  }
  std::vector<CubicBezier> chain;
  const double rest = (1 - kSimplifyShare) * tolerance;
  fit_thinned(there, rest, chain);
  append_cap(there[n - 1], back[0], t[n - 1], end_depth, chain);
  fit_thinned(back, rest, chain);
  append_cap(back[n - 1], there[0], -t[0], start_depth, chain);
  return chain;
}

}  // namespace

std::vector<std::vector<CubicBezier>> stroke_outline(std::span<const Vec2> points,
                                                     std::span<const double> widths,
                                                     double tolerance) {
  std::vector<std::vector<CubicBezier>> chains;
  Centre c = centre_line(points, widths, tolerance);
  if (c.size() < 2) return chains;
  const double end_nose = shorten_for_nose(c);
  std::ranges::reverse(c);
  double start_depth = shorten_for_nose(c);
  std::ranges::reverse(c);
  std::size_t begin = 0;
  const auto cut = [&](std::size_t at, double depth) {
    const auto piece = std::span(c).subspan(begin, at - begin + 1);
    chains.push_back(piece_outline(piece, start_depth, depth, tolerance));
    start_depth = depth;
    begin = at;
  };
  double tight = 0;
  for (std::size_t i = 1; i + 1 < c.size(); ++i) {
    const Vec2 in = flat(c[i]) - flat(c[i - 1]), on = flat(c[i + 1]) - flat(c[i]);
    const double l0 = glm::length(in), l1 = glm::length(on);
    const double cosine = glm::dot(in, on) / (l0 * l1);
    const double turn = std::acos(std::clamp(cosine, -1.0, 1.0));
    // Radius of curvature about min(l0, l1) / turn: within half the width the inner side folds.
    const bool folds = std::min(l0, l1) < c[i].z * turn;
    tight = folds ? tight + turn : 0;
    if (cosine >= kCornerCosine && tight <= kMaxTightTurn) continue;
    cut(i, c[i].z);
    tight = 0;
  }
  cut(c.size() - 1, end_nose);
  return chains;
}

}  // namespace burin
