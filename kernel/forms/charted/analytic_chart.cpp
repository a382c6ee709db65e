#include <burin/forms/charted/analytic_chart.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

class PlaneChart final : public Chart {
 public:
  PlaneChart(const ChartAxes& axes, const ParameterBox& domain) : a_(axes), domain_(domain) {}
  Vec3 position(Vec2 uv) const override { return a_.origin + uv.x * a_.x + uv.y * a_.y; }
  SurfaceDerivatives derivatives(Vec2 uv) const override {
    SurfaceDerivatives d;
    d.p = position(uv);
    d.u = a_.x;
    d.v = a_.y;
    return d;
  }
  ParameterBox domain() const override { return domain_; }
  FaceKind kind() const override { return FaceKind::Plane; }
  double largest_area() const override { return glm::length(glm::cross(a_.x, a_.y)); }

 private:
  ChartAxes a_;
  ParameterBox domain_;
};

/// The unit circle in the x-y plane of the axes at the angle u, and its derivative.
struct Circle {
  Vec3 out, along;
  Circle(const ChartAxes& a, double u) {
    const double c = std::cos(u), s = std::sin(u);
    out = c * a.x + s * a.y;
    along = c * a.y - s * a.x;
  }
};

/// Cylinder and cone: (radius + v slope) out(u) + v rise z.
class ConicChart final : public Chart {
 public:
  ConicChart(const ChartAxes& axes, double radius, double half_angle, double v0, double v1)
      : a_(axes), radius_(radius), slope_(std::sin(half_angle)), rise_(std::cos(half_angle)) {
    domain_ = {{0, v0}, {kTurn, v1}};
    if (slope_ == 0) return;
    const double tip = -radius_ / slope_;
    if (0.5 * (v0 + v1) > tip) {
      domain_.min.y = std::max(v0, tip);
    } else {
      domain_.max.y = std::min(v1, tip);
    }
  }
  Vec3 position(Vec2 uv) const override {
    return a_.origin + (radius_ + uv.y * slope_) * Circle(a_, uv.x).out + uv.y * rise_ * a_.z;
  }
  SurfaceDerivatives derivatives(Vec2 uv) const override {
    const Circle c(a_, uv.x);
    const double r = radius_ + uv.y * slope_;
    SurfaceDerivatives d;
    d.p = a_.origin + r * c.out + uv.y * rise_ * a_.z;
    d.u = r * c.along;
    d.v = slope_ * c.out + rise_ * a_.z;
    d.uu = -r * c.out;
    d.uv = slope_ * c.along;
    return d;
  }
  ParameterBox domain() const override { return domain_; }
  Vec2 period() const override { return {kTurn, 0}; }
  FaceKind kind() const override { return slope_ == 0 ? FaceKind::Cylinder : FaceKind::Cone; }
  double largest_area() const override {
    return std::max(std::abs(radius_ + domain_.min.y * slope_),
                    std::abs(radius_ + domain_.max.y * slope_));
  }

 private:
  ChartAxes a_;
  double radius_, slope_, rise_;
  ParameterBox domain_;
};

struct RoundShape {
  ChartAxes axes;
  double major = 0, minor = 0;
};

/// Sphere (major 0) and torus: (major + minor cos v) out(u) + minor sin v z.
class RoundSurfaceChart final : public Chart {
 public:
  explicit RoundSurfaceChart(const RoundShape& shape) : round(shape) {}
  Vec3 position(Vec2 uv) const override {
    const double c = std::cos(uv.y), s = std::sin(uv.y);
    return round.axes.origin + (round.major + round.minor * c) * Circle(round.axes, uv.x).out +
           round.minor * s * round.axes.z;
  }
  SurfaceDerivatives derivatives(Vec2 uv) const override {
    const Circle k(round.axes, uv.x);
    const double c = std::cos(uv.y), s = std::sin(uv.y);
    const double r = round.major + round.minor * c;
    SurfaceDerivatives d;
    d.p = round.axes.origin + r * k.out + round.minor * s * round.axes.z;
    d.u = r * k.along;
    d.v = round.minor * (c * round.axes.z - s * k.out);
    d.uu = -r * k.out;
    d.uv = -round.minor * s * k.along;
    d.vv = -round.minor * (s * round.axes.z + c * k.out);
    return d;
  }
  ParameterBox domain() const override {
    if (sphere()) return {{0, -0.25 * kTurn}, {kTurn, 0.25 * kTurn}};
    return {{0, 0}, {kTurn, kTurn}};
  }
  Vec2 period() const override { return {kTurn, sphere() ? 0 : kTurn}; }
  FaceKind kind() const override { return sphere() ? FaceKind::Sphere : FaceKind::Torus; }
  double largest_area() const override {
    return (std::abs(round.major) + std::abs(round.minor)) * std::abs(round.minor);
  }
  bool sphere() const { return round.major == 0; }

  const RoundShape round;
};

}  // namespace

std::shared_ptr<const Chart> plane_chart(const ChartAxes& axes, const ParameterBox& domain) {
  return std::make_shared<PlaneChart>(axes, domain);
}
std::shared_ptr<const Chart> cylinder_chart(const ChartAxes& axes, double radius, double v0,
                                            double v1) {
  return std::make_shared<ConicChart>(axes, radius, 0, v0, v1);
}
std::shared_ptr<const Chart> cone_chart(const ChartAxes& axes, double radius, double half_angle,
                                        double v0, double v1) {
  return std::make_shared<ConicChart>(axes, radius, half_angle, v0, v1);
}
std::shared_ptr<const Chart> sphere_chart(const ChartAxes& axes, double radius) {
  return std::make_shared<RoundSurfaceChart>(RoundShape{axes, 0, radius});
}
std::shared_ptr<const Chart> torus_chart(const ChartAxes& axes, double major, double minor) {
  return std::make_shared<RoundSurfaceChart>(RoundShape{axes, major, minor});
}

}  // namespace burin
