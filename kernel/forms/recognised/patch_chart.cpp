#include "patch_chart.h"

#include "facets.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::recognised {
namespace {

// Cosine between normal and axis from which on a patch is a cap.
constexpr double kCap = 0.8;
// Steps of Newton's method for a cubic profile, which is nearly a line.
constexpr int kChartSteps = 8;
// Of the domain, on each side beyond the triangles: the curves of edges leave their chords.
constexpr double kBeside = 0.1;

}  // namespace

PatchChart::PatchChart(const Patch& patch, int cap, double pole)
    : patch_(patch),
      cap_(cap),
      pole_(pole),
      e1_(any_orthogonal(patch.axis.direction)),
      e2_(glm::cross(patch.axis.direction, e1_)) {}

int PatchChart::cap_at(const Patch& patch, Vec3 p) {
  if (patch.sheet) return 0;
  const double along = patch.foot(patch.axis.profile(p)).normal.y;
  return along > kCap ? 1 : along < -kCap ? -1 : 0;
}

Vec2 PatchChart::period() const {
  if (patch_.sheet) return patch_.sheet->period();
  return cap_ != 0 ? Vec2(0) : Vec2(kTurn, circle() ? kTurn : 0);
}

bool PatchChart::at_pole(Vec3 p) const {
  return cap_ == 0 && !patch_.sheet && patch_.axis.profile(p).x <= pole_;
}

void PatchChart::extend_to(Vec2 uv) {
  low_ = glm::min(low_, uv);
  high_ = glm::max(high_, uv);
}

ParameterBox PatchChart::domain() const {
  const Vec2 beside = kBeside * (high_ - low_);
  ParameterBox box{low_ - beside, high_ + beside};
  for (int i = 0; i < 2; ++i) {
    const double turn = period()[i];
    if (!(turn > 0)) continue;
    box.min[i] = low_[i];
    box.max[i] = low_[i] + turn;
  }
  if (cap_ != 0 || patch_.profile != Patch::Profile::Line) return box;
  // A cone ends at its tip.
  const double slope = patch_.along().x, at_0 = patch_.offset * patch_.normal.x;
  if (slope == 0) return box;
  const double tip = -at_0 / slope;
  (slope > 0 ? box.min.y : box.max.y) =
      slope > 0 ? std::max(box.min.y, tip) : std::min(box.max.y, tip);
  return box;
}

double PatchChart::largest_area() const {
  if (cap_ != 0 || patch_.sheet || patch_.profile == Patch::Profile::Cubic) return 0;
  if (circle()) {
    return std::abs(patch_.radius) * (std::abs(patch_.middle.x) + std::abs(patch_.radius));
  }
  const ParameterBox box = domain();
  return std::max(std::abs(profile(box.min.y).p.x), std::abs(profile(box.max.y).p.x));
}

Vec2 PatchChart::parameters(Vec3 p) const {
  if (patch_.sheet) return patch_.sheet->locate(p, patch_.window);
  const Vec3 d = p - patch_.axis.origin;
  const Vec2 xy(glm::dot(d, e1_), glm::dot(d, e2_));
  if (cap_ != 0) return xy;
  const Vec2 rh = patch_.axis.profile(p), off = rh - patch_.middle;
  return {std::atan2(xy.y, xy.x),
          circle() ? std::atan2(off.y, off.x) : glm::dot(rh, patch_.along())};
}

PatchChart::Profile PatchChart::profile(double v) const {
  if (circle()) {
    const double r = std::abs(patch_.radius);
    const Vec2 out(std::cos(v), std::sin(v));
    return {patch_.middle + r * out, r * Vec2(-out.y, out.x), -r * out};
  }
  const Patch::Foot foot = patch_.foot(patch_.offset * patch_.normal + v * patch_.along());
  if (patch_.profile == Patch::Profile::Line) return {foot.point, patch_.along(), Vec2(0)};
  const double slope =
      -glm::dot(foot.normal, patch_.along()) / glm::dot(foot.normal, patch_.normal);
  const double g = std::sqrt(1 + slope * slope);
  return {foot.point, patch_.along() + slope * patch_.normal,
          -foot.curvature * g * g * g * patch_.normal};
}

double PatchChart::at_radius(double r) const {
  if (circle()) {
    const double x = r - patch_.middle.x;
    const double y = std::sqrt(std::max(0.0, patch_.radius * patch_.radius - x * x));
    return std::atan2((patch_.radius > 0) == (cap_ > 0) ? y : -y, x);
  }
  double v = 0;
  for (int i = 0; i < kChartSteps; ++i) {
    const Profile at = profile(v);
    const double off = at.p.x - r;
    if (off == 0 || at.d.x == 0) break;
    v -= off / at.d.x;
  }
  return v;
}

SurfaceDerivatives PatchChart::derivatives(Vec2 uv) const {
  if (patch_.sheet) return patch_.sheet->derivatives(uv);
  return cap_ != 0 ? across(uv) : around(uv);
}

SurfaceDerivatives PatchChart::around(Vec2 uv) const {
  const Vec3& axis = patch_.axis.direction;
  const Vec3 out = std::cos(uv.x) * e1_ + std::sin(uv.x) * e2_, round = glm::cross(axis, out);
  const Profile at = profile(uv.y);
  const double r = std::abs(at.p.x) > pole_ ? at.p.x : 0;
  SurfaceDerivatives d;
  d.p = patch_.axis.origin + at.p.x * out + at.p.y * axis;
  d.u = r * round;
  d.v = at.d.x * out + at.d.y * axis;
  d.uu = -r * out;
  d.uv = at.d.x * round;
  d.vv = at.dd.x * out + at.dd.y * axis;
  return d;
}

SurfaceDerivatives PatchChart::across(Vec2 uv) const {
  const Vec3& axis = patch_.axis.direction;
  const double r = glm::length(uv);
  const Profile at = profile(at_radius(r));
  // The height over the distance from the axis, and its derivatives.
  const double slope = at.d.x != 0 ? at.d.y / at.d.x : 0;
  const double bend =
      at.d.x != 0 ? (at.dd.y * at.d.x - at.d.y * at.dd.x) / (at.d.x * at.d.x * at.d.x) : 0;
  const Vec2 out = r > 0 ? uv / r : Vec2(1, 0);
  // At the axis what bends along the meridian bends so all round.
  const double round = r > pole_ ? slope / r : bend;
  SurfaceDerivatives d;
  d.p = patch_.axis.origin + uv.x * e1_ + uv.y * e2_ + at.p.y * axis;
  d.u = e1_ + slope * out.x * axis;
  d.v = e2_ + slope * out.y * axis;
  d.uu = (bend * out.x * out.x + round * out.y * out.y) * axis;
  d.uv = (bend - round) * out.x * out.y * axis;
  d.vv = (bend * out.y * out.y + round * out.x * out.x) * axis;
  return d;
}

}  // namespace burin::recognised
