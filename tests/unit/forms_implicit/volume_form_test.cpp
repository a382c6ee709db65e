// Sampled analytic shapes against the shapes themselves.

#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/implicit/volume_function.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace burin {
namespace {

using namespace implicit;

// A grid of n samples a side over [-half, half].
VolumeGrid sampled(std::int32_t n, double half, const std::function<double(Vec3)>& f) {
  VolumeGrid g;
  g.size = {n, n, n};
  g.origin = Vec3(-half);
  g.steps = Mat3(2 * half / (n - 1));
  for (int k = 0; k < n; ++k) {
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        g.samples.push_back(static_cast<float>(f(g.origin + g.steps * Vec3(i, j, k))));
      }
    }
  }
  return g;
}

struct Seen {
  RunContext context;
  std::unique_ptr<ImplicitForm> form;
  std::unique_ptr<Camera> eye;
  std::shared_ptr<const Surface> surface;

  explicit Seen(std::shared_ptr<const ImplicitFunction> f) {
    form = std::make_unique<ImplicitForm>(std::move(f), std::nullopt, context);
    ViewOptions view;
    view.direction = {1, -1, 1};
    eye = std::make_unique<Camera>(
        Camera::fit([&](const Mat3& axes) { return form->bounds(axes); }, view));
    RealiseOptions options;
    options.tolerance = 0.02;
    options.view = eye.get();
    surface = form->realise(options, context);
  }
};

// How far the angle between normal and view is from a right one where the volume has its contour.
double worst_contour(const Seen& seen, const std::function<Vec3(Vec3)>& normal) {
  const ProxyMesh& proxy = seen.surface->proxy();
  const Vec3 view = glm::normalize(Vec3(1, -1, 1));
  double worst = 0;
  std::size_t n = 0;
  for (std::size_t w = 0; w < proxy.wedge_vertex.size(); ++w) {
    if (!proxy.on_contour[w]) continue;
    ++n;
    const Vec3 p = proxy.mesh.positions[proxy.wedge_vertex[w]];
    worst = std::max(worst, std::abs(std::asin(glm::dot(normal(p), view))));
  }
  EXPECT_GT(n, 100u);
  return worst;
}

// 64 samples across a torus of 20 and 7 mm: steps of 0.9 mm.
TEST(VolumeForm, ATorusHasItsContourAndCurvature) {
  const auto distance = [](Vec3 p) { return std::hypot(std::hypot(p.x, p.y) - 20, p.z) - 7; };
  const auto normal = [](Vec3 p) {
    const double r = std::hypot(p.x, p.y);
    return glm::normalize(p - Vec3(20 * p.x / r, 20 * p.y / r, 0));
  };
  const Seen seen(make_volume_function(sampled(64, 29, distance),
                                       {.inside_above = false, .interpolate = true}, RunContext()));
  EXPECT_LT(worst_contour(seen, normal), 0.002);
  double off = 0, turn = 0, bend = 0, along = 0;
  for (const SurfacePoint& p : seen.surface->cover({.count = 400}, seen.context)) {
    const Frame f = seen.surface->frame(p);
    const double r = std::hypot(p.position.x, p.position.y);
    off = std::max(off, std::abs(distance(p.position)));
    turn = std::max(turn, std::acos(std::min(1.0, glm::dot(f.normal, normal(p.position)))));
    bend = std::max(bend, std::abs(f.k1 - 1.0 / 7));
    // The second direction runs round the axis.
    const Vec3 round = glm::normalize(Vec3(-p.position.y, p.position.x, 0));
    along = std::max(along, std::acos(std::min(1.0, std::abs(glm::dot(f.d2, round)))));
    EXPECT_NEAR(f.k2, (r - 20) / 7 / r, 0.01);
  }
  EXPECT_LT(off, 0.002);
  EXPECT_LT(turn, 0.002);
  EXPECT_LT(bend, 0.01);
  EXPECT_LT(along, 0.05);
}

TEST(VolumeForm, AnEllipsoidHasItsContour) {
  const Vec3 half(25, 15, 10);
  const auto f = [&](Vec3 p) { return 1 - glm::dot(p / half, p / half); };
  const auto normal = [&](Vec3 p) { return glm::normalize(p / half / half); };
  // Quadratic data is what an interpolating spline has exactly, but for the borders; as
  // coefficients a cubic lifts it by a third of a second difference an axis, and has its slopes.
  const Seen exact(make_volume_function(sampled(64, 28, f), {.interpolate = true}, RunContext()));
  EXPECT_LT(worst_contour(exact, normal), 1.2e-4);  // 1e-4 of it FacingFunction's own
  const Seen smooth(make_volume_function(sampled(64, 28, f), {}, RunContext()));
  EXPECT_LT(worst_contour(smooth, normal), 1.01e-4);
  const Box3 box = smooth.form->bounds(Mat3(1));
  EXPECT_NEAR(box.max.x, 25, 0.1);
  EXPECT_NEAR(exact.form->bounds(Mat3(1)).max.x, 25, 1e-4);
}

// Three blended cylinders as a formula and as its samples.
TEST(VolumeForm, ASampledBlendIsTheBlend) {
  const Expression c = cylinder(6, 40);
  const auto f = make_function(
      smooth_unite(smooth_unite(c, rotate(c, {90, 0, 0}), 5), rotate(c, {0, 90, 0}), 5));
  // Inside the cylinders' ends, so that planes cut them.
  Seen seen(make_volume_function(sampled(72, 18, [&](Vec3 p) { return f->value(p); }),
                                 {.inside_above = false, .interpolate = true}, RunContext()));
  EXPECT_EQ(seen.surface->proxy().region_count, 7);  // the blend and six ends
  double off = 0, turn = 0;
  for (const SurfacePoint& p : seen.surface->cover({.count = 400}, seen.context)) {
    const Vec3 away = glm::abs(p.position);
    if (std::max({away.x, away.y, away.z}) > 17.9) continue;
    const Gradient1 g = f->gradient(p.position);
    off = std::max(off, std::abs(g.value));
    turn = std::max(turn, std::acos(std::min(1.0, glm::dot(seen.surface->frame(p).normal,
                                                           glm::normalize(g.gradient)))));
  }
  EXPECT_LT(off, 0.02);
  EXPECT_LT(turn, 0.03);
}

}  // namespace
}  // namespace burin
