#include "closed_loop.h"

#include <burin/base/error.h>

#include "spline_to_occt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

/// A knot where a curve turns by more (radians) ends an edge: a polygon along a smooth curve is
/// one.
constexpr double kCorner = 0.3;

using Curve = Handle(Geom2d_BSplineCurve);

Vec2 vec(const gp_Pnt2d& p) { return {p.X(), p.Y()}; }

class LoopCloser {
 public:
  explicit LoopCloser(const LoopDomain& domain) : domain_(domain) {}
  ClosedLoop close(const TrimLoop& loop);

 private:
  Vec2 unit(Vec2 p) const { return (p - domain_.min) / (domain_.max - domain_.min); }
  bool meet(const gp_Pnt2d& a, const gp_Pnt2d& b) const {
    return glm::distance(unit(vec(a)), unit(vec(b))) <= kTrimGap;
  }
  void head_to_tail(LoopCurves& curves) const;
  void join_ends(LoopCurves& curves) const;
  void cut(const Curve& curve, LoopCurves& out) const;
  bool moves(const Curve& curve) const;
  bool corner(const Curve& curve, int knot) const;
  void sample(ClosedLoop& loop) const;

  const LoopDomain& domain_;
};

/// Curves that run against the loop are turned.
void LoopCloser::head_to_tail(LoopCurves& curves) const {
  if (curves.size() < 2) return;
  const Curve &a = curves[0], &b = curves[1];
  const auto meets_next = [&](const gp_Pnt2d& p) {
    return meet(p, b->StartPoint()) || meet(p, b->EndPoint());
  };
  if (!meets_next(a->EndPoint()) && meets_next(a->StartPoint())) a->Reverse();
  for (std::size_t i = 1; i < curves.size(); ++i) {
    const gp_Pnt2d end = curves[i - 1]->EndPoint();
    if (!meet(end, curves[i]->StartPoint()) && meet(end, curves[i]->EndPoint())) {
      curves[i]->Reverse();
    }
  }
}

void LoopCloser::join_ends(LoopCurves& curves) const {
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Curve &a = curves[i], &b = curves[(i + 1) % curves.size()];
    const Vec2 end = vec(a->EndPoint()), start = vec(b->StartPoint());
    if (!meet(a->EndPoint(), b->StartPoint())) {
      throw GeometryError(
          fmt::format("it does not close: curve {} ends at ({:.6g}, {:.6g}), the next begins at "
                      "({:.6g}, {:.6g}); make the trimmed surface again",
                      i + 1, end.x, end.y, start.x, start.y));
    }
    const gp_Pnt2d middle(0.5 * (end.x + start.x), 0.5 * (end.y + start.y));
    a->SetPole(a->NbPoles(), middle);
    b->SetPole(1, middle);
  }
}

bool LoopCloser::corner(const Curve& curve, int knot) const {
  if (curve->Multiplicity(knot) < curve->Degree()) return false;
  gp_Pnt2d p;
  gp_Vec2d before, after;
  const double t = curve->Knot(knot);
  curve->LocalD1(t, knot - 1, knot, p, before);
  curve->LocalD1(t, knot, knot + 1, p, after);
  const Vec2 scale = 1.0 / (domain_.max - domain_.min);
  const Vec2 a = Vec2(before.X(), before.Y()) * scale, b = Vec2(after.X(), after.Y()) * scale;
  return !(std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b))) < kCorner);
}

/// Nothing but a point is no edge.
bool LoopCloser::moves(const Curve& curve) const {
  constexpr double kPoint = 1e-12;
  for (int i = 2; i <= curve->NbPoles(); ++i) {
    if (glm::distance(unit(vec(curve->Pole(i))), unit(vec(curve->Pole(1)))) > kPoint) return true;
  }
  return false;
}

void LoopCloser::cut(const Curve& curve, LoopCurves& out) const {
  int from = curve->FirstUKnotIndex();
  const int end = curve->LastUKnotIndex();
  for (int k = from + 1; k <= end; ++k) {
    if (k < end && !corner(curve, k)) continue;
    Curve piece = Curve::DownCast(curve->Copy());
    if (from > curve->FirstUKnotIndex() || k < end) {
      piece->Segment(curve->Knot(from), curve->Knot(k));
    }
    if (moves(piece)) out.push_back(piece);
    from = k;
  }
}

void LoopCloser::sample(ClosedLoop& loop) const {
  constexpr int kPerSpan = 32;
  for (const Curve& curve : loop.curves) {
    const int samples = curve->Degree() == 1 ? 2 : kPerSpan;
    for (int k = curve->FirstUKnotIndex(); k < curve->LastUKnotIndex(); ++k) {
      const double from = curve->Knot(k), to = curve->Knot(k + 1);
      for (int i = 0; i < samples; ++i) {
        loop.polygon.push_back(unit(vec(curve->Value(from + (to - from) * i / samples))));
      }
    }
  }
  loop.min = loop.max = loop.polygon.front();
  Vec2 before = loop.polygon.back();
  for (const Vec2 p : loop.polygon) {
    loop.min = glm::min(loop.min, p);
    loop.max = glm::max(loop.max, p);
    loop.area += 0.5 * (before.x * p.y - before.y * p.x);
    before = p;
  }
}

ClosedLoop LoopCloser::close(const TrimLoop& loop) {
  if (loop.curves.empty()) throw GeometryError("it has no curve; leave it out");
  LoopCurves curves;
  for (const TrimCurve& curve : loop.curves) curves.push_back(occt_curve(curve));
  head_to_tail(curves);
  join_ends(curves);
  ClosedLoop out;
  out.place = loop.place;
  for (const Curve& curve : curves) cut(curve, out.curves);
  if (!out.curves.empty()) sample(out);
  const auto outside = [](Vec2 p) {
    return std::min(p.x, p.y) < -kTrimGap || std::max(p.x, p.y) > 1 + kTrimGap;
  };
  if (outside(out.min) || outside(out.max)) {
    throw GeometryError(fmt::format(
        "it leaves the domain of its surface, u from {:.6g} to {:.6g} and v from {:.6g} to {:.6g}; "
        "make the trimmed surface again",
        domain_.min.x, domain_.max.x, domain_.min.y, domain_.max.y));
  }
  constexpr double kNothing = 1e-10;  // of the domain
  if (!(std::abs(out.area) > kNothing)) {
    throw GeometryError("it encloses nothing; leave it out");
  }
  return out;
}

}  // namespace

void ClosedLoop::turn(bool counter_clockwise) {
  if ((area > 0) == counter_clockwise) return;
  std::ranges::reverse(curves);
  for (const Curve& curve : curves) curve->Reverse();
  std::ranges::reverse(polygon);
  area = -area;
}

ClosedLoop close_loop(const TrimLoop& loop, const LoopDomain& domain) {
  return LoopCloser(domain).close(loop);
}

}  // namespace burin
