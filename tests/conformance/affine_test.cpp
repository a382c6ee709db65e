/// What forms become under affine maps, against closed forms: a stretched ball is an ellipsoid.

#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/illustrate/illustrate.h>
#include <burin/mesh/placed_mesh.h>
#include <burin/surface/placed_frame.h>

#include "forms.h"

#include <BRepPrimAPI_MakeSphere.hxx>
#include <burin_test/exact.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

using test::line_angle;

struct Ball {
  std::string name;
  std::function<std::shared_ptr<const Form>()> make;
  /// Shares that its curvatures may be off: meshes estimate them.
  double curvature = 1e-6;
};

std::vector<Ball> balls() {
  return {
      {"Nurbs", [] { return test::parametric_form({make_nurbs_chart(test::sphere_nurbs(1))}); }},
      {"Implicit", [] { return test::implicit_form(implicit::sphere(1)); }},
      {"Brep", [] { return test::brep_form(BRepPrimAPI_MakeSphere(1).Shape()); }},
      {"Recognised",
       [] { return test::recognised_form(test::turned(test::sphere_profile(1, 48), 48)); }, 1e-5},
      {"Mesh", [] { return test::mesh_form(test::ellipsoid(Vec3(1), 240, 120)); }, 0.02},
  };
}

/// Turned about no axis of the ellipsoid.
Placement ellipsoid_of(Vec3 half) {
  return {rotation({30, 20, 50}) * Mat3(half.x, 0, 0, 0, half.y, 0, 0, 0, half.z), {4, -1, 2}};
}

constexpr Vec3 kHalf(3, 1, 2);

class StretchedBall : public testing::TestWithParam<Ball> {
 protected:
  std::shared_ptr<const Form> form(const Placement& by) { return placed(GetParam().make(), by); }
  RunContext context_;
};

TEST_P(StretchedBall, HasTheCurvaturesOfAnEllipsoid) {
  for (const bool mirrored : {false, true}) {
    Placement by = ellipsoid_of(kHalf);
    if (mirrored) by.linear[0] *= -1;
    const auto surface = form(by)->realise({.tolerance = 0.003}, context_);
    const Placement back = inverse(by);
    for (const SurfacePoint& p : surface->cover({.count = 200, .seed = 2}, context_)) {
      const Frame f = surface->frame(p);
      const Vec3 q = kHalf * back.point(p.position);  // along the axes of the ellipsoid
      const Vec3 a2 = kHalf * kHalf, slope = q / a2;
      const double h = glm::dot(slope, slope), product = a2.x * a2.y * a2.z;
      const double gauss = 1 / (product * h * h);
      const double mean = (a2.x + a2.y + a2.z - glm::dot(q, q)) / (2 * product * h * std::sqrt(h));
      const double off = GetParam().curvature;
      EXPECT_NEAR(f.k1 * f.k2, gauss, 2 * off * mean * mean);
      EXPECT_NEAR(0.5 * (f.k1 + f.k2), mean, off * mean);
      const Vec3 normal = glm::normalize(glm::transpose(back.linear) * (q / kHalf));
      EXPECT_LT(glm::distance(f.normal, normal), std::sqrt(off));
      EXPECT_EQ(f.kind, FaceKind::Freeform);
    }
  }
}

TEST_P(StretchedBall, IsDrawnAsAnEllipse) {
  const Placement by = ellipsoid_of(kHalf);
  Scene scene;
  scene.parts.push_back({"ball", "", form(by)});
  ViewOptions view;
  view.scale = 10;
  view.paper = {200, 150};
  for (const Vec3 direction : {Vec3(1, -1, 1), Vec3(0.2, 1, -0.4)}) {
    view.direction = direction;
    const Camera camera = Camera::fit([&](const Mat3& axes) { return scene.bounds(axes); }, view);
    const Drawing drawing = illustrate(scene, camera, builtin_style("outline"), {}, context_);
    // The support function of the ellipsoid along right and up: p is on its outline where
    // p . inverse(M) p = 1, M of the products of the mapped axes.
    const Mat3 gram = by.linear * glm::transpose(by.linear);
    const Vec3 r = camera.right(), u = camera.up();
    const double a = glm::dot(r, gram * r), b = glm::dot(r, gram * u), c = glm::dot(u, gram * u);
    const double det = a * c - b * b;
    const Vec2 middle = camera.to_paper(by.offset);
    double length = 0;
    std::size_t points = 0;
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        EXPECT_EQ(path.kind, LineClass::Contour);
        for (std::size_t i = 0; i < path.points.size(); ++i) {
          const Vec2 p = (path.points[i] - middle) / camera.scale();
          const double on = std::sqrt((c * p.x * p.x - 2 * b * p.x * p.y + a * p.y * p.y) / det);
          // Paper mm along the way from the middle.
          EXPECT_NEAR(std::abs(1 - 1 / on) * glm::length(p) * camera.scale(), 0, 0.02);
          if (i > 0) length += glm::distance(path.points[i], path.points[i - 1]);
          ++points;
        }
        if (path.closed) length += glm::distance(path.points.back(), path.points.front());
      }
    }
    EXPECT_GT(points, 20u);
    // Ramanujan's circumference, within 1e-5 of it for such ellipses.
    const double root = std::sqrt(0.25 * (a - c) * (a - c) + b * b);
    const double half1 = std::sqrt(0.5 * (a + c) + root), half2 = std::sqrt(0.5 * (a + c) - root);
    const double h = std::pow((half1 - half2) / (half1 + half2), 2);
    const double around = test::kPi * (half1 + half2) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
    EXPECT_NEAR(length / (around * camera.scale()), 1, 2e-3);
  }
}

TEST_P(StretchedBall, MeasuresAsASpheroid) {
  const auto m = form(ellipsoid_of({1, 1, 2}))->measure(context_);
  const double e = std::sqrt(0.75), area = 2 * test::kPi * (1 + 2 / e * std::asin(e));
  // OCCT's samples on rational splines are 4e-3 off; 48 facets of a ball lack 7e-3 of its volume.
  EXPECT_NEAR(m.area / area, 1, 5e-3);
  EXPECT_NEAR(m.volume / (8 * test::kPi / 3), 1, 1e-2);
}

INSTANTIATE_TEST_SUITE_P(Balls, StretchedBall, testing::ValuesIn(balls()),
                         [](const auto& ball) { return ball.param.name; });

/// The kinds of the faces of a surface, as frames tell them.
std::vector<FaceKind> kinds_of(const Surface& surface) {
  std::vector<FaceKind> kinds;
  for (std::uint32_t f = 0; f < surface.proxy().wedges.size(); ++f) {
    const FaceKind kind = surface.frame(surface.lift({f, Vec3(1.0 / 3)})).kind;
    if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
  }
  std::ranges::sort(kinds);
  return kinds;
}

TEST(AffineMaps, AMirroredCylinderIsOneAndASlantedOneIsNot) {
  RunContext context;
  using Kinds = std::vector<FaceKind>;
  for (const auto& make :
       {std::function([] { return test::brep_form(test::cylinder_shape(2, 5)); }),
        std::function([] {
          return test::recognised_form(test::turned({{2, 0}, {2, 5}}, 24));
        })}) {
    const auto mirrored = placed(make(), test::mirrored())->realise({}, context);
    EXPECT_EQ(kinds_of(*mirrored), (Kinds{FaceKind::Plane, FaceKind::Cylinder}));
    const auto sheared = placed(make(), test::sheared())->realise({}, context);
    EXPECT_EQ(kinds_of(*sheared), (Kinds{FaceKind::Plane, FaceKind::Freeform}));
    const Vec3 ruling = glm::normalize(test::sheared().vector({0, 0, 1}));
    int walls = 0;
    for (const SurfacePoint& p : sheared->cover({.count = 200}, context)) {
      const Frame f = sheared->frame(p);
      if (f.kind == FaceKind::Plane) continue;
      ++walls;
      EXPECT_NEAR(f.k2, 0, 1e-9);
      EXPECT_LT(line_angle(f.d2, ruling), 1e-4);
      EXPECT_FALSE(f.umbilic);
    }
    EXPECT_GT(walls, 50);
  }
}

TEST(AffineMaps, FramesGoOverIntoThoseOfTheMappedChart) {
  const auto chart = test::torus_chart(3, 1);
  for (const Placement& by : {test::sheared(), test::mirrored_sheared(), test::mirrored()}) {
    for (int i = 0; i < 40; ++i) {
      const Vec2 uv = chart->domain().min + Vec2(0.13 * i, 0.29 * i);
      const SurfaceDerivatives d = chart->derivatives(uv), there = placed(by, d);
      const Vec3 n = glm::normalize(glm::cross(d.u, d.v));
      const Frame mapped = placed(by, chart_frame(d, n, FaceKind::Torus, 10));
      const Frame exact = chart_frame(there, placed_normal(by, n), mapped.kind, 10);
      EXPECT_LT(glm::distance(mapped.normal, exact.normal), 1e-12);
      EXPECT_NEAR(mapped.k1, exact.k1, 1e-9);
      EXPECT_NEAR(mapped.k2, exact.k2, 1e-9);
      EXPECT_LT(line_angle(mapped.d1, exact.d1), 1e-4);
      EXPECT_LT(glm::distance(mapped.du, exact.du), 1e-12);
    }
  }
}

/// Points of all lines on the paper.
std::vector<Vec2> drawn_points(const std::shared_ptr<const Form>& form, const Camera& camera) {
  Scene scene;
  scene.parts.push_back({"part", "", form});
  RunContext context;
  const Drawing drawing = illustrate(scene, camera, builtin_style("outline"), {}, context);
  std::vector<Vec2> points;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (std::size_t i = 1; i < path.points.size() + (path.closed ? 1 : 0); ++i) {
        const Vec2 a = path.points[i - 1], b = path.points[i % path.points.size()];
        const int n = std::max(1, static_cast<int>(glm::distance(a, b) / 0.05));
        for (int k = 0; k < n; ++k) points.push_back(glm::mix(a, b, static_cast<double>(k) / n));
      }
    }
  }
  return points;
}

double farthest(const std::vector<Vec2>& of, const std::vector<Vec2>& from) {
  double most = 0;
  for (std::size_t i = 0; i < of.size(); i += 3) {
    double least = 1e9;
    for (const Vec2& q : from) least = std::min(least, glm::distance(of[i], q));
    most = std::max(most, least);
  }
  return most;
}

// A part and its mirror image, seen from the front: one drawing is the other, reversed.
TEST(AffineMaps, AMirroredPartIsDrawnAsTheMirrorImage) {
  const Placement mirror{Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1), Vec3(0)};
  const Placement turned{rotation({25, 40, 10}), Vec3(0)};
  ViewOptions view;
  view.direction = {0, -1, 0};
  view.scale = 8;
  view.center = Vec3(0);
  view.paper = {200, 150};
  const Camera camera = Camera::fit([](const Mat3&) { return Box3{Vec3(-9), Vec3(9)}; }, view);
  const auto cones = [] {
    return test::recognised_form(test::turned({{2, 0}, {2, 2}, {1, 4}, {1, 5}}, 30));
  };
  const auto hollow = [] {
    return test::implicit_form(implicit::subtract(implicit::box(2, 3, 4), implicit::sphere(1.2)));
  };
  for (const auto& form : {test::brep_form(test::filleted_box_shape(0.25)), cones(), hollow(),
                           test::mesh_form(test::torus(3, 1, 60, 30))}) {
    const auto here = drawn_points(placed(form, turned), camera);
    auto there = drawn_points(placed(placed(form, turned), mirror), camera);
    for (Vec2& p : there) p.x = 200 - p.x;
    EXPECT_GT(here.size(), 500u);
    EXPECT_LT(farthest(here, there), 0.06);  // half of it lies between the points
    EXPECT_LT(farthest(there, here), 0.06);
  }
}

TEST(AffineMaps, AStretchedMeshIsTheMeshOfTheStretchedPoints) {
  RunContext context;
  const TriMesh mesh = test::torus(3, 1, 60, 30);
  const auto one = placed(test::mesh_form(mesh), test::mirrored_sheared());
  const auto other = test::mesh_form(placed(mesh, test::mirrored_sheared()));
  const auto a = one->realise({}, context), b = other->realise({}, context);
  ASSERT_EQ(a->proxy().mesh.triangles, b->proxy().mesh.triangles);
  ASSERT_EQ(a->proxy().edge_kind, b->proxy().edge_kind);
  for (std::size_t v = 0; v < a->proxy().mesh.positions.size(); ++v) {
    EXPECT_LT(glm::distance(a->proxy().mesh.positions[v], b->proxy().mesh.positions[v]), 1e-12);
  }
}

// Two flat faces at 10 degrees have no crease between them; ten times as steep they have one.
TEST(AffineMaps, CreasesAreThoseOfThePlacedMesh) {
  RunContext context;
  const double rise = 2 * std::tan(5 * test::kPi / 180);
  const TriMesh roof{{{0, -1, 0}, {0, 1, 0}, {2, 0, -rise}, {-2, 0, -rise}},
                     {{0, 2, 1}, {0, 1, 3}}};
  const auto creases = [&](const Placement& by) {
    const auto surface = placed(test::mesh_form(roof), by)->realise({}, context);
    const auto& kinds = surface->proxy().edge_kind;
    return std::ranges::count_if(kinds, [](EdgeKind k) {
      return k == EdgeKind::ConvexCrease || k == EdgeKind::ConcaveCrease;
    });
  };
  const auto high = [](double by) { return Placement{Mat3(1, 0, 0, 0, 1, 0, 0, 0, by), Vec3(0)}; };
  EXPECT_EQ(creases(high(1)), 0);
  EXPECT_EQ(creases(high(-1)), 0);
  EXPECT_EQ(creases(high(10)), 2);
  EXPECT_EQ(creases(high(-10)), 2);
}

TEST(AffineMaps, ADefinitionIsTheShapeAndWhatBecameOfIt) {
  const auto form = test::brep_form(test::box_shape(1, 2, 3));
  const auto at = [&](const Placement& by) { return placed(form, by)->definition(); };
  const Placement turn{rotation({10, 20, 30}), {1, 2, 3}};
  const Placement sheared = test::sheared(), mirrored = test::mirrored();
  EXPECT_TRUE(at(turn).same(form->definition()));
  EXPECT_TRUE(at(after(turn, sheared)).same(at(sheared)));
  EXPECT_FALSE(at(after(sheared, turn)).same(at(sheared))) << "stretched along another way";
  EXPECT_FALSE(at(sheared).same(form->definition()));
  EXPECT_FALSE(at(mirrored).same(form->definition()));
  EXPECT_TRUE(at(after(turn, mirrored)).same(at(mirrored)));
  EXPECT_TRUE(at(after(mirrored, mirrored)).same(form->definition()));
}

TEST(AffineMaps, ExactFacesAreMeasuredExactly) {
  RunContext context;
  const auto m =
      placed(test::brep_form(test::box_shape(1, 2, 3)), {Mat3(2, 0, 0, 0, -1, 0, 0, 0, 1), Vec3(0)})
          ->measure(context);
  EXPECT_NEAR(m.area, 2 * (4 + 6 + 6), 1e-9);
  EXPECT_NEAR(m.volume, 12, 1e-9);
  EXPECT_EQ(m.faces, 6);
  EXPECT_EQ(m.edges, 12);
}

TEST(AffineMaps, CopiesThatAreOnlyMovedShareWhatIsStretched) {
  RunContext context;
  const Placer placer(test::recognised_form(test::turned({{2, 0}, {2, 5}}, 24)));
  Placement here = test::sheared(), there = here;
  there.offset += Vec3(50, 0, 0);
  const auto a = placer.at(here), b = placer.at(there), c = placed(a, {Mat3(1), {50, 0, 0}});
  EXPECT_TRUE(b->same_as(*c));
  const auto one = a->realise({}, context), other = b->realise({}, context);
  EXPECT_LT(glm::distance(one->proxy().mesh.positions[5] + Vec3(50, 0, 0),
                          other->proxy().mesh.positions[5]),
            1e-9);
}

}  // namespace
}  // namespace burin
