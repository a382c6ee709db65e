#include <burin/drawing/bezier.h>

#include "schneider.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

/// A segment so much longer than its neighbours, after simplification, is no sample of a curve but
/// a straight run.
constexpr double kStraightRatio = 4;
/// Points nearer than this share of the tolerance are one.
constexpr double kRepeatShare = 0.01;

std::vector<Vec2> without_repeats(std::span<const Vec2> points, bool closed, double distance) {
  std::vector<Vec2> out;
  out.reserve(points.size());
  for (const Vec2& p : points) {
    if (out.empty() || glm::distance(out.back(), p) > distance) out.push_back(p);
  }
  if (!closed && out.size() > 1) out.back() = points.back();
  if (!closed && out.size() > 1 && out[out.size() - 2] == out.back()) out.pop_back();
  while (closed && out.size() > 1 && glm::distance(out.back(), out.front()) <= distance) {
    out.pop_back();
  }
  return out;
}

/// An open polyline without the points that it can spare.
std::vector<Vec2> thinned(std::span<const Vec2> points, double tolerance) {
  std::vector<Vec2> out;
  for (const std::size_t i : simplify(points, tolerance)) {
    if (out.empty() || out.back() != points[i]) out.push_back(points[i]);
  }
  return out;
}

/// A closed polyline, thinned in two halves that meet at the first point and at the one farthest
/// from it; the first point is repeated at the end.
std::vector<Vec2> thinned_loop(std::vector<Vec2> points, double tolerance) {
  const Vec2 first = points.front();
  const auto far = std::max_element(points.begin(), points.end(), [&](Vec2 a, Vec2 b) {
    return glm::distance(a, first) < glm::distance(b, first);
  });
  const auto middle = static_cast<std::size_t>(far - points.begin());
  points.push_back(first);
  std::vector<Vec2> out = thinned(std::span(points).first(middle + 1), tolerance);
  out.pop_back();
  const std::vector<Vec2> rest = thinned(std::span(points).subspan(middle), tolerance);
  out.insert(out.end(), rest.begin(), rest.end());
  return out;
}

/// A corner stays one where it turns by more than 30 degrees, or where a smooth curve through it
/// would bow away from the shorter chord by more than the tolerance (length times turn over eight,
/// as for a circle's arc).
bool is_corner(Vec2 a, Vec2 b, Vec2 c, double tolerance) {
  const double l0 = glm::distance(a, b), l1 = glm::distance(b, c);
  const double cosine = glm::dot(b - a, c - b) / (l0 * l1);
  if (cosine < kCornerCosine) return true;
  const double turn = std::acos(std::min(cosine, 1.0));
  return std::min(l0, l1) * turn / 8 > tolerance;
}

bool is_long(std::span<const Vec2> p, std::size_t segment) {
  const auto length = [&](std::size_t i) { return glm::distance(p[i], p[i + 1]); };
  const double l = length(segment);
  return (segment == 0 || l > kStraightRatio * length(segment - 1)) &&
         (segment + 2 >= p.size() || l > kStraightRatio * length(segment + 1));
}

/// The tangent at the beginning of p as the circle through its first three points has it.
Vec2 end_tangent(Vec2 p0, Vec2 p1, Vec2 p2) {
  const Vec2 chord = direction(p0, p1), at1 = circle_tangent(p0, p1, p2);
  return 2 * glm::dot(at1, chord) * chord - at1;
}

struct Ends {
  Vec2 start{0}, end{0};
  bool has_start = false, has_end = false;
};

/// Fits a run without corners or straight parts.
void fit_smooth(std::span<const Vec2> p, Ends ends, double tolerance,
                std::vector<CubicBezier>& out) {
  const std::size_t n = p.size();
  if (n == 2 && !ends.has_start && !ends.has_end) {
    out.push_back(straight(p[0], p[1]));
    return;
  }
  if (!ends.has_start) ends.start = n > 2 ? end_tangent(p[0], p[1], p[2]) : direction(p[0], p[1]);
  if (!ends.has_end) {
    ends.end = n > 2 ? -end_tangent(p[n - 1], p[n - 2], p[n - 3]) : direction(p[0], p[1]);
  }
  fit_run(p, ends.start, ends.end, tolerance, out);
}

/// Fits a run without corners: straight parts are lines that give their direction to the curves on
/// both sides.
void fit_between_corners(std::span<const Vec2> p, Ends ends, double tolerance,
                         std::vector<CubicBezier>& out) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i) {
    if (p.size() > 2 && !is_long(p, i)) continue;
    const Vec2 along = direction(p[i], p[i + 1]);
    Ends before = ends;
    before.end = along;
    before.has_end = true;
    if (i > begin) fit_smooth(p.subspan(begin, i - begin + 1), before, tolerance, out);
    out.push_back(straight(p[i], p[i + 1]));
    ends.start = along;
    ends.has_start = true;
    begin = i + 1;
  }
  if (begin + 1 < p.size()) fit_smooth(p.subspan(begin), ends, tolerance, out);
}

void fit_open(std::span<const Vec2> p, Ends ends, double tolerance, std::vector<CubicBezier>& out) {
  std::size_t begin = 0;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) {
    if (!is_corner(p[i - 1], p[i], p[i + 1], tolerance)) continue;
    Ends here = ends;
    here.has_end = false;
    fit_between_corners(p.subspan(begin, i - begin + 1), here, tolerance, out);
    ends.has_start = false;
    begin = i;
  }
  fit_between_corners(p.subspan(begin), ends, tolerance, out);
}

void start_loop_at(std::vector<Vec2>& p, std::size_t i) {
  p.pop_back();
  std::rotate(p.begin(), p.begin() + static_cast<std::ptrdiff_t>(i), p.end());
  p.push_back(p.front());
}

/// Turns a loop (first point repeated at the end) so that it starts at a corner, or else at a
/// straight part; without any, the seam gets one tangent for both sides.
Ends open_loop(std::vector<Vec2>& p, double tolerance) {
  const std::size_t n = p.size() - 1;
  const auto at = [&](std::size_t i) { return p[i % n]; };
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_corner(at(i + n - 1), at(i), at(i + 1), tolerance)) continue;
    start_loop_at(p, i);
    return {};
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_long(std::array{at(i + n - 1), at(i), at(i + 1), at(i + 2)}, 1)) continue;
    const Vec2 along = direction(at(i), at(i + 1));
    start_loop_at(p, i);
    return {along, along, true, true};
  }
  const Vec2 seam = circle_tangent(p[n - 1], p[0], p[1]);
  return {seam, seam, true, true};
}

}  // namespace

bool is_straight(const CubicBezier& c, double tolerance) {
  const Vec2 d = c[3] - c[0];
  const double l = glm::length(d);
  if (l == 0) return false;
  const double s1 = glm::dot(c[1] - c[0], d), s2 = glm::dot(c[2] - c[0], d);
  // The curve is within 3/4 of its control points' distances.
  const double off =
      0.75 * std::max(std::abs(cross2(d, c[1] - c[0])), std::abs(cross2(d, c[2] - c[0]))) / l;
  return off <= tolerance && s1 >= 0 && s2 >= s1 && s2 <= l * l;
}

std::vector<CubicBezier> fit_cubics(std::span<const Vec2> points, bool closed, double tolerance) {
  std::vector<CubicBezier> out;
  std::vector<Vec2> p = without_repeats(points, closed, kRepeatShare * tolerance);
  if (p.size() < 3) closed = false;
  const std::size_t before = p.size() + (closed ? 1 : 0);
  if (p.size() >= 2)
    p = closed ? thinned_loop(std::move(p), kSimplifyShare * tolerance)
               : thinned(p, kSimplifyShare * tolerance);
  if (p.size() < 2) return out;
  const double spent = kRepeatShare + (p.size() < before ? kSimplifyShare : 0.0);
  const double rest = (1 - spent) * tolerance;
  if (closed && p.size() > 3) {
    const Ends ends = open_loop(p, rest);
    fit_open(p, ends, rest, out);
  } else {
    fit_open(p, {}, rest, out);
  }
  return out;
}

void fit_thinned(std::span<const Vec2> points, double tolerance, std::vector<CubicBezier>& out) {
  const std::vector<Vec2> p = without_repeats(points, false, kRepeatShare * tolerance);
  if (p.size() > 1) fit_open(p, {}, (1 - kRepeatShare) * tolerance, out);
}

}  // namespace burin
