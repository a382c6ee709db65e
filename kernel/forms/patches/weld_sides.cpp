// The curves of sides: whether two are one.

#include "weld.h"

#include <algorithm>
#include <cmath>

namespace burin::detail {
namespace {

// Places of a side that are compared; enough for the sides of patches of any sensible degree.
constexpr int kSamples = 33;
// Entries of a table between two parameters; between them Newton's method.
constexpr int kTable = 65;
constexpr int kNewton = 12;

double guess_from_samples(const SideCurve& c, Vec3 point) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < c.samples.size(); ++i) {
    if (glm::distance(c.samples[i], point) < glm::distance(c.samples[best], point)) best = i;
  }
  return static_cast<double>(best) / (kSamples - 1);
}

bool same_speed(const SideCurve& a, const SideCurve& b, bool backward, double distance) {
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const std::size_t j = backward ? a.samples.size() - 1 - i : i;
    if (!(glm::distance(a.samples[i], b.samples[j]) <= distance)) return false;
  }
  return true;
}

// b's t for even t of a, by projection; empty where a point of a is not on b or the order is not
// kept.
std::vector<double> table_between(const SideCurve& a, const SideCurve& b, bool backward,
                                  double distance) {
  std::vector<double> table;
  double last = backward ? 1 : 0;
  for (int i = 0; i < kTable; ++i) {
    const double t = static_cast<double>(i) / (kTable - 1);
    const double end = backward ? 1 - t : t;
    const Vec3 p = a.at(t);
    const bool tip = i == 0 || i == kTable - 1;
    const double s = tip ? end : b.nearest(p, i == 1 ? guess_from_samples(b, p) : last);
    const bool ordered = backward ? s <= last : s >= last;
    if (!ordered || !(glm::distance(b.at(s), p) <= distance)) return {};
    table.push_back(last = s);
  }
  return table;
}

}  // namespace

Vec2 side_uv(const ParameterBox& box, int side, double t) {
  const double s = side_descends(side) ? 1 - t : t;
  // The ends exactly, whatever rounding does between.
  const auto lerp = [s](double a, double b) { return s >= 1 ? b : a + s * (b - a); };
  switch (side) {
    case 0:
      return {lerp(box.min.x, box.max.x), box.min.y};
    case 1:
      return {box.max.x, lerp(box.min.y, box.max.y)};
    case 2:
      return {lerp(box.min.x, box.max.x), box.max.y};
    default:
      return {box.min.x, lerp(box.min.y, box.max.y)};
  }
}

SideCurve side_curve(const Chart& chart, int side) {
  SideCurve c;
  c.chart = &chart;
  c.box = chart.domain();
  c.side = side;
  for (int i = 0; i < kSamples; ++i) {
    const Vec3 p = c.at(static_cast<double>(i) / (kSamples - 1));
    c.samples.push_back(p);
    c.low = i == 0 ? p : glm::min(c.low, p);
    c.high = i == 0 ? p : glm::max(c.high, p);
  }
  return c;
}

Vec3 SideCurve::slope(double t, Vec3& point) const {
  const SurfaceDerivatives d = chart->derivatives(side_uv(box, side, t));
  point = d.p;
  const Vec2 size = box.size();
  const Vec3 along = side_direction(side) == 0 ? size.x * d.u : size.y * d.v;
  return side_descends(side) ? -along : along;
}

double SideCurve::nearest(Vec3 point, double t) const {
  for (int i = 0; i < kNewton; ++i) {
    Vec3 p;
    const Vec3 d = slope(t, p);
    const double square = glm::dot(d, d);
    if (!(square > 0)) break;
    const double step = glm::dot(point - p, d) / square;
    t = std::clamp(t + step, 0.0, 1.0);
    if (std::abs(step) < 1e-15) break;
  }
  return t;
}

SideMatch match(const SideCurve& a, const SideCurve& b, double distance) {
  SideMatch result;
  const Vec3 slack(distance);
  const auto apart = [](Vec3 high, Vec3 low) {
    return high.x < low.x || high.y < low.y || high.z < low.z;
  };
  if (apart(a.high + slack, b.low) || apart(b.high + slack, a.low)) return result;
  const auto near = [&](const Vec3& p, const Vec3& q) { return glm::distance(p, q) <= distance; };
  // Patches that are oriented alike run along their common side in opposite directions.
  for (const bool backward : {true, false}) {
    const Vec3& first = backward ? b.samples.back() : b.samples.front();
    const Vec3& last = backward ? b.samples.front() : b.samples.back();
    if (!near(a.samples.front(), first) || !near(a.samples.back(), last)) continue;
    result.backward = backward;
    if (same_speed(a, b, backward, distance)) {
      result.found = true;
      return result;
    }
    result.table = table_between(a, b, backward, distance);
    if (!result.table.empty()) {
      result.found = true;
      return result;
    }
  }
  return result;
}

}  // namespace burin::detail
