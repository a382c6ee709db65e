#include "patch_chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::recognised {
namespace {

// Cosine between normal and axis from which on a patch is a cap.
constexpr double kCap = 0.8;
// Steps of Newton's method for a cubic profile, which is nearly a line.
constexpr int kSteps = 8;

}  // namespace

PatchChart::PatchChart(const Patch& patch, int cap, double pole)
    : patch_(patch),
      cap_(cap),
      pole_(pole),
      e1_(any_orthogonal(patch.axis.direction)),
      e2_(glm::cross(patch.axis.direction, e1_)) {}

int PatchChart::cap_at(const Patch& patch, Vec3 p) {
  const double along = patch.foot(patch.axis.profile(p)).normal.y;
  return along > kCap ? 1 : along < -kCap ? -1 : 0;
}

Vec2 PatchChart::period() const {
  constexpr double kTurn = 2 * std::numbers::pi;
  return cap_ != 0 ? Vec2(0) : Vec2(kTurn, circle() ? kTurn : 0);
}

bool PatchChart::at_pole(Vec3 p) const { return cap_ == 0 && patch_.axis.profile(p).x <= pole_; }

Vec2 PatchChart::parameters(Vec3 p) const {
  const Vec3 d = p - patch_.axis.origin;
  const Vec2 xy(glm::dot(d, e1_), glm::dot(d, e2_));
  if (cap_ != 0) return xy;
  const Vec2 rh = patch_.axis.profile(p), off = rh - patch_.middle;
  return {std::atan2(xy.y, xy.x),
          circle() ? std::atan2(off.y, off.x) : glm::dot(rh, patch_.along())};
}

Patch::Foot PatchChart::profile(double v, Vec2& derivative) const {
  if (circle()) {
    const Vec2 out(std::cos(v), std::sin(v));
    derivative = std::abs(patch_.radius) * Vec2(-out.y, out.x);
    return patch_.foot(patch_.middle + std::abs(patch_.radius) * out);
  }
  const Patch::Foot foot = patch_.foot(patch_.offset * patch_.normal + v * patch_.along());
  const double slope =
      -glm::dot(foot.normal, patch_.along()) / glm::dot(foot.normal, patch_.normal);
  derivative = patch_.along() + slope * patch_.normal;
  return foot;
}

double PatchChart::at_radius(double r) const {
  if (circle()) {
    const double x = r - patch_.middle.x;
    const double y = std::sqrt(std::max(0.0, patch_.radius * patch_.radius - x * x));
    return std::atan2((patch_.radius > 0) == (cap_ > 0) ? y : -y, x);
  }
  double v = 0;
  for (int i = 0; i < kSteps; ++i) {
    Vec2 slope;
    const double off = profile(v, slope).point.x - r;
    if (off == 0 || slope.x == 0) break;
    v -= off / slope.x;
  }
  return v;
}

SurfaceSample PatchChart::sample(Vec2 uv) const { return cap_ != 0 ? across(uv) : around(uv); }

SurfaceSample PatchChart::around(Vec2 uv) const {
  const Vec3& axis = patch_.axis.direction;
  const Vec3 out = std::cos(uv.x) * e1_ + std::sin(uv.x) * e2_, round = glm::cross(axis, out);
  Vec2 slope;
  const Patch::Foot foot = profile(uv.y, slope);
  SurfaceSample s;
  s.position = patch_.axis.origin + foot.point.x * out + foot.point.y * axis;
  s.normal = foot.normal.x * out + foot.normal.y * axis;
  s.u = (foot.point.x > pole_ ? foot.point.x : 0) * round;
  s.v = slope.x * out + slope.y * axis;
  s.normal_u = foot.normal.x * round;
  s.normal_v = foot.curvature * s.v;
  return s;
}

SurfaceSample PatchChart::across(Vec2 uv) const {
  const Vec3& axis = patch_.axis.direction;
  const Vec3 off = uv.x * e1_ + uv.y * e2_;
  Vec2 slope;
  const Patch::Foot foot = profile(at_radius(glm::length(off)), slope);
  SurfaceSample s;
  s.position = patch_.axis.origin + off + foot.point.y * axis;
  const Frame frame = patch_.frame(s.position);
  s.normal = frame.normal;
  const double up = glm::dot(frame.normal, axis);
  // Tangents above the two directions, and how the normal turns along them.
  const auto above = [&](Vec3 e) { return e - glm::dot(frame.normal, e) / up * axis; };
  const auto turn = [&](Vec3 t) {
    return frame.k1 * glm::dot(t, frame.d1) * frame.d1 +
           frame.k2 * glm::dot(t, frame.d2) * frame.d2;
  };
  s.u = above(e1_);
  s.v = above(e2_);
  s.normal_u = turn(s.u);
  s.normal_v = turn(s.v);
  return s;
}

}  // namespace burin::recognised
