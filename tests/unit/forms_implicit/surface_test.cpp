/// Implicit surfaces: triangles, creases, contours, frames and marches against analytic truths.

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/camera/camera.h>
#include <burin/camera/facing.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <thread>

namespace burin {
namespace {

using namespace implicit;

struct Made {
  std::shared_ptr<const ImplicitFunction> function;
  std::shared_ptr<const ImplicitForm> form;
  std::shared_ptr<const Surface> surface;
  Diagnostics diagnostics;
  const ProxyMesh& proxy() const { return surface->proxy(); }
};

Made make(const Expression& e, double tolerance = 0.01, std::optional<Box3> domain = {},
          const Camera* view = nullptr) {
  RunContext context;
  Made m;
  m.function = make_function(e);
  m.form = std::make_shared<ImplicitForm>(m.function, domain, context);
  RealiseOptions options;
  options.tolerance = tolerance;
  options.view = view;
  options.diagnostics = &m.diagnostics;
  m.surface = m.form->realise(options, context);
  return m;
}

Camera camera(const Form& form, Vec3 direction, std::optional<double> perspective = {}) {
  ViewOptions view;
  view.direction = direction;
  view.perspective = perspective;
  return Camera::fit([&](const Mat3& axes) { return form.bounds(axes); }, view);
}

long euler_of(const ProxyMesh& p) {
  return static_cast<long>(p.mesh.positions.size()) -
         static_cast<long>(p.mesh.triangles.size()) / 2;
}

/// Closed, and all vertices on f = 0 within 1e-9 of the size.
void expect_sound_surface(const Made& m) {
  const ProxyMesh& p = m.proxy();
  const double size = p.mesh.bounds().diagonal();
  for (const HalfEdge o : p.topology.opposite) ASSERT_NE(o, kNoHalfEdge);
  for (const Vec3& v : p.mesh.positions) {
    const Gradient1 g = m.function->gradient(v);
    EXPECT_LE(std::abs(g.value), 1e-9 * size * glm::length(g.gradient));
  }
  double volume = 0;
  for (const Triangle& t : p.mesh.triangles) {
    volume += glm::dot(p.mesh.positions[t[0]],
                       glm::cross(p.mesh.positions[t[1]], p.mesh.positions[t[2]])) /
              6;
  }
  EXPECT_GT(volume, 0);
}

std::size_t crease_edges(const ProxyMesh& p, EdgeKind kind) {
  return static_cast<std::size_t>(std::count(p.edge_kind.begin(), p.edge_kind.end(), kind)) / 2;
}

bool reports(const Diagnostics& d, const std::string& code) {
  return std::any_of(d.entries().begin(), d.entries().end(),
                     [&](const Diagnostic& e) { return e.code == code; });
}

TEST(ImplicitMesh, ATorusIsClosedAndOfGenusOne) {
  const Made m = make(torus(3, 1));
  expect_sound_surface(m);
  EXPECT_EQ(euler_of(m.proxy()), 0);
  EXPECT_EQ(m.proxy().region_count, 1);
  EXPECT_LE(m.proxy().tolerance, 0.02);
  EXPECT_TRUE(m.diagnostics.empty());
}

TEST(ImplicitMesh, ACubeMinusABallHasItsTrueEdges) {
  const Made m = make(subtract(box(2, 2, 2), sphere(1.2)), 0.005);
  expect_sound_surface(m);
  EXPECT_EQ(euler_of(m.proxy()), -8);
  // Six faces with a round hole each, and the hollow.
  EXPECT_EQ(m.proxy().region_count, 7);
  EXPECT_EQ(crease_edges(m.proxy(), EdgeKind::ConcaveCrease), 0u);
  const double rim = std::sqrt(1.44 - 1);
  double edges = 0, rims = 0;
  for (std::size_t h = 0; h < m.proxy().edge_kind.size(); ++h) {
    if (m.proxy().edge_kind[h] != EdgeKind::ConvexCrease) continue;
    const auto e = static_cast<HalfEdge>(h);
    const Vec3 a = m.proxy().mesh.positions[origin(m.proxy().mesh, e)],
               b = m.proxy().mesh.positions[origin(m.proxy().mesh, next_in_face(e))];
    int ones = 0;
    for (int i = 0; i < 3; ++i) ones += std::abs(std::abs(a[i]) - 1) < 1e-9;
    if (ones >= 2) {
      edges += 0.5 * glm::distance(a, b);
    } else {
      ASSERT_EQ(ones, 1);
      EXPECT_NEAR(glm::length(a), 1.2, 1e-9);
      rims += 0.5 * glm::distance(a, b);
    }
  }
  EXPECT_NEAR(edges, 24, 1e-9);
  EXPECT_NEAR(rims, 6 * 2 * std::numbers::pi * rim, 0.02);
}

TEST(ImplicitMesh, ATurnedBoxHasEightCorners) {
  const Made m = make(rotate(box(1, 2, 3), {20, 30, 40}), 0.005);
  expect_sound_surface(m);
  EXPECT_EQ(euler_of(m.proxy()), 2);
  EXPECT_EQ(m.proxy().region_count, 6);
  std::map<std::uint32_t, std::set<std::uint32_t>> wedges;
  for (std::uint32_t w = 0; w < m.proxy().wedge_vertex.size(); ++w) {
    wedges[m.proxy().wedge_vertex[w]].insert(w);
  }
  const auto corners = std::count_if(wedges.begin(), wedges.end(),
                                     [](const auto& v) { return v.second.size() == 3; });
  EXPECT_EQ(corners, 8);
}

TEST(ImplicitMesh, ConesAndNeedlesHaveTheirTips) {
  // Where the z axis goes.
  const Vec3 axis =
      make_function(rotate(plane(0, 0, 1, 0), {10, 20, 30}))->gradient(Vec3(0)).gradient;
  for (const double height : {1.0, 2.0, 12.0}) {
    const Made m = make(rotate(cone(1, 0, height), {10, 20, 30}), 0.005);
    double least = 1;
    for (const Vec3& p : m.proxy().mesh.positions) {
      least = std::min(least, glm::distance(p, 0.5 * height * axis));
    }
    EXPECT_LT(least, 1e-8) << height;
    EXPECT_EQ(euler_of(m.proxy()), 2);
    EXPECT_EQ(m.proxy().region_count, 2);
  }
}

TEST(ImplicitMesh, UnionsHaveConcaveEdges) {
  const Made m = make(unite(sphere(1), translate(sphere(1), {1.2, 0, 0})), 0.005);
  expect_sound_surface(m);
  EXPECT_EQ(euler_of(m.proxy()), 2);
  EXPECT_EQ(crease_edges(m.proxy(), EdgeKind::ConvexCrease), 0u);
  EXPECT_GT(crease_edges(m.proxy(), EdgeKind::ConcaveCrease), 20u);
}

TEST(ImplicitMesh, FilletsAreNoCreases) {
  const Expression c = cylinder(1, 6);
  const Made m = make(smooth_unite(c, rotate(c, {90, 0, 0}), 0.5), 0.003);
  expect_sound_surface(m);
  EXPECT_EQ(euler_of(m.proxy()), 2);
  EXPECT_EQ(m.proxy().region_count, 5);  // four lids
}

TEST(ImplicitMesh, AllOfManyBodiesAreFound) {
  Expression balls = sphere(0.4);
  for (int i = 1; i < 27; ++i) {
    balls = unite(balls, translate(sphere(0.4), {i % 3, i / 3 % 3, i / 9}));
  }
  const Made m = make(balls);
  EXPECT_EQ(m.proxy().topology.component_closed.size(), 27u);
  EXPECT_EQ(euler_of(m.proxy()), 54);
  // A ball of a 64th of the other one's size beside it.
  const Made two = make(unite(sphere(1), translate(sphere(1.0 / 32), {1.1, 0, 0})), 0.001);
  EXPECT_EQ(two.proxy().topology.component_closed.size(), 2u);
}

TEST(ImplicitMesh, InnerHollowsAreFound) {
  const Made m = make(shell(sphere(1), 0.1));
  EXPECT_EQ(m.proxy().topology.component_closed.size(), 2u);
  expect_sound_surface(m);
}

// How far the middles of the triangles lie off the surface, in model mm.
double farthest_middle(const Made& m) {
  double most = 0;
  const TriMesh& mesh = m.proxy().mesh;
  for (const Triangle& t : mesh.triangles) {
    const Gradient1 g = m.function->gradient(
        (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0);
    most = std::max(most, std::abs(g.value) / glm::length(g.gradient));
  }
  return most;
}

TEST(ImplicitMesh, ThinWedgesKeepTheirEdges) {
  // A trough cut into a post: its rim runs out at an angle of 8 degrees where the two are tangent
  // to each other. And what a slanted box leaves of another.
  const Expression post = cylinder(20, 30), bar = rotate(cylinder(20.4, 60), {90, 0, 0});
  const Expression slanted = rotate(box(60, 60, 30.01), {5, 3, 0});
  for (const double tolerance : {0.012, 0.01, 0.008, 0.003}) {
    for (const double up : {18.0, 10.0}) {
      const Made m = make(subtract(post, translate(bar, {0, 0, up})), tolerance);
      expect_sound_surface(m);
      EXPECT_LT(farthest_middle(m), 0.08) << tolerance << " " << up;
    }
    const Made m = make(subtract(box(30, 30, 30), slanted), tolerance);
    expect_sound_surface(m);
    EXPECT_LT(farthest_middle(m), 0.12) << tolerance;
  }
}

TEST(ImplicitMesh, WhatIsThinAlongItsOutermostFacesIsSeen) {
  // Ribs of 0.3 mm and less along the edges of the box.
  const Expression sheet = intersect(gyroid(20, 2.5), box(36, 36, 36));
  for (const double tolerance : {0.02, 0.013, 0.01}) {
    const Made m = make(sheet, tolerance);
    expect_sound_surface(m);
    EXPECT_LT(farthest_middle(m), 0.04) << tolerance;
    EXPECT_FALSE(reports(m.diagnostics, "implicit.thin"));
  }
}

TEST(ImplicitMesh, WallsThinnerThanTheirTrianglesAreTold) {
  // A crescent, at most 0.3 mm thick.
  const Expression ball = sphere(10);
  EXPECT_TRUE(reports(make(subtract(ball, translate(ball, {0.3, 0, 0})), 0.02).diagnostics,
                      "implicit.thin"));
  EXPECT_FALSE(
      reports(make(subtract(ball, translate(ball, {4, 0, 0})), 0.02).diagnostics, "implicit.thin"));
}

TEST(ImplicitMesh, LensesThinnerThanAStepOfTheLookAreFound) {
  // Steps of 0.16 mm; the lens is 0.1 mm thick, the plate 0.05.
  const Made lens = make(intersect(sphere(10), translate(sphere(10), {19.9, 0, 0})), 0.001);
  expect_sound_surface(lens);
  EXPECT_EQ(euler_of(lens.proxy()), 2);
  EXPECT_NEAR(lens.proxy().mesh.bounds().size().y, 2 * std::sqrt(100 - 9.95 * 9.95), 0.01);
  EXPECT_EQ(euler_of(make(box(20, 20, 0.05)).proxy()), 2);
}

TEST(ImplicitMesh, ScaleAndPlaceDoNotMatter) {
  const Expression shape = subtract(box(2, 2, 2), sphere(1.2));
  const Made a = make(shape, 0.005);
  for (const double s : {1e-3, 1e4}) {
    const Made b = make(scale(shape, s), 0.005 * s);
    EXPECT_EQ(euler_of(b.proxy()), -8);
    EXPECT_EQ(b.proxy().region_count, 7);
  }
  const Made far = make(translate(shape, {1e5, -1e5, 1e5}), 0.005);
  EXPECT_EQ(euler_of(far.proxy()), -8);
  EXPECT_EQ(far.proxy().region_count, 7);
  EXPECT_EQ(a.proxy().region_count, 7);
}

TEST(ImplicitMesh, TheSameForAnyNumberOfThreads) {
  const Expression shape = subtract(box(2, 2, 2), sphere(1.2));
  const Made a = make(shape, 0.005);
  const ThreadLimit one(1);
  const Made b = make(shape, 0.005);
  EXPECT_EQ(a.proxy().mesh.positions, b.proxy().mesh.positions);
  EXPECT_EQ(a.proxy().mesh.triangles, b.proxy().mesh.triangles);
}

TEST(ImplicitMesh, EndlessSurfacesAreClippedByTheDomain) {
  const Box3 domain{{-1, -2, -3}, {1, 2, 3}};
  const Made m = make(plane(0.3, 0.2, 1, 0.1), 0.01, domain);
  EXPECT_TRUE(reports(m.diagnostics, "implicit.clipped"));
  for (const HalfEdge o : m.proxy().topology.opposite) ASSERT_NE(o, kNoHalfEdge);
  EXPECT_EQ(m.proxy().region_count, 6);  // the plane, four walls and the floor
  const Box3 b = m.form->bounds(Mat3(1));
  EXPECT_NEAR(b.min.z, -3, 1e-9);
  EXPECT_NEAR(b.max.x, 1, 1e-9);
}

TEST(ImplicitMesh, BoundsAreThoseOfTheSurface) {
  const Made m = make(rotate(torus(3, 1), {90, 0, 0}));
  const Box3 b = m.form->bounds(Mat3(1));
  EXPECT_LT(glm::distance(b.min, Vec3(-4, -1, -4)), 1e-8);
  EXPECT_LT(glm::distance(b.max, Vec3(4, 1, 4)), 1e-8);
  const Vec3 d = glm::normalize(Vec3(1, 2, 3));
  Mat3 axes(1);
  axes[0][0] = d.x;
  axes[1][0] = d.y;
  axes[2][0] = d.z;
  EXPECT_NEAR(m.form->bounds(axes).max.x, 3 * std::hypot(d.x, d.z) + 1, 1e-8);
}

TEST(ImplicitErrors, FunctionsWithoutASurfaceSayWhy) {
  const Box3 cube{Vec3(-1), Vec3(1)};
  const Expression x = Expression::x();
  const auto refused = [&](const Expression& e, std::optional<Box3> domain, const char* what) {
    try {
      make(e, 0.01, domain);
      ADD_FAILURE() << "not refused: " << what;
    } catch (const GeometryError& error) {
      EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  };
  refused(sphere(1) + 2.0, {}, "nowhere negative");
  refused(Expression(0.0), cube, "nowhere negative");
  refused(sphere(9), cube, "negative everywhere");
  refused(implicit::round(sphere(3)), Box3{Vec3(-4), Vec3(4)}, "no slope");
  refused(sphere(1), Box3{Vec3(-1e7), Vec3(1e7)}, "in steps of 1.5");
  refused(implicit::sqrt(-square(x) - 1.0), cube, "not a number");
  refused(plane(0, 0, 1, 0), {}, "`bounds x0,");
  refused(sphere(1), Box3{Vec3(1), Vec3(-1)}, "empty, endless or reaches");
  refused(sphere(1), Box3{Vec3(-1e300), Vec3(1e300)}, "empty, endless or reaches");
}

TEST(ImplicitErrors, PolesAndJumpsAreTold) {
  const Made m = make(1.0 / Expression::x(), 0.01, Box3{Vec3(-1), Vec3(1)});
  EXPECT_TRUE(reports(m.diagnostics, "implicit.not_on_surface"));
}

TEST(ImplicitErrors, ACancelledSurveyEndsAtOnce) {
  const Expression x = Expression::x(), y = Expression::y(), z = Expression::z();
  // Everywhere and endlessly fine.
  const auto f = make_function(sin(1000 * x * y) + sin(1000 * y * z) + sin(1000 * z * x));
  RunContext context;
  std::thread stop([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    context.cancel();
  });
  EXPECT_THROW(ImplicitForm(f, Box3{Vec3(-9), Vec3(9)}, context), Cancelled);
  stop.join();
}

TEST(ImplicitContours, LieExactlyOnTheSurfaceAndEdgeOn) {
  const auto f = torus(3, 1);
  for (const std::optional<double> perspective : {std::optional<double>(), std::optional(40.0)}) {
    const Made plain = make(f);
    const Camera eye = camera(*plain.form, {1, -1, 1}, perspective);
    const FacingFunction g(eye);
    const Made m = make(f, 0.01, {}, &eye);
    const ProxyMesh& p = m.proxy();
    std::size_t on = 0;
    for (std::uint32_t w = 0; w < p.wedge_vertex.size(); ++w) {
      if (!p.on_contour[w]) continue;
      ++on;
      EXPECT_LT(std::abs(g(p.wedge_position(w), p.wedge_normal[w])), 1e-8);
    }
    EXPECT_GT(on, 200u);
    // No triangle with corners on both sides, and every contour vertex between a front and a back.
    for (std::uint32_t t = 0; t < p.wedges.size(); ++t) {
      int front = 0, back = 0;
      for (const std::uint32_t w : p.wedges[t]) {
        if (p.on_contour[w]) continue;
        (g(p.wedge_position(w), p.wedge_normal[w]) > 0 ? front : back)++;
      }
      EXPECT_TRUE(front == 0 || back == 0);
    }
  }
}

TEST(ImplicitContours, ChordsAreWithinAHundredthOfAMillimetreOfPaper) {
  const Made plain = make(sphere(1), 0.02);
  const Camera eye = camera(*plain.form, {1, -1, 1});
  const Made m = make(sphere(1), 0.02, {}, &eye);
  const ProxyMesh& p = m.proxy();
  double length = 0, most = 0;
  const Vec3 d = eye.direction();
  for (std::uint32_t t = 0; t < p.wedges.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = p.wedges[t][k], b = p.wedges[t][(k + 1) % 3];
      if (!p.on_contour[a] || !p.on_contour[b]) continue;
      const Vec3 u = reject(p.wedge_position(a), d), v = reject(p.wedge_position(b), d);
      length += 0.5 * glm::distance(u, v);
      most = std::max(most, eye.scale() * (1 - glm::length(0.5 * (u + v))));
    }
  }
  EXPECT_NEAR(length, 2 * std::numbers::pi, 0.001);
  EXPECT_LT(most, 0.01);
}

TEST(ImplicitFrames, ATorusHasItsCurvatures) {
  const Made m = make(torus(3, 1));
  RunContext context;
  for (const SurfacePoint& p : m.surface->cover({.count = 300}, context)) {
    const Frame f = m.surface->frame(p);
    const double rho = std::hypot(p.position.x, p.position.y), c = rho - 3;
    EXPECT_NEAR(std::hypot(c, p.position.z), 1, 1e-9);
    const Vec3 around = Vec3(-p.position.y, p.position.x, 0) / rho;
    EXPECT_NEAR(f.k1, 1, 1e-8);
    EXPECT_NEAR(f.k2, c / rho, 1e-8);
    EXPECT_NEAR(std::abs(glm::dot(f.d2, around)), 1, 1e-8);
    EXPECT_FALSE(f.umbilic);
    EXPECT_NEAR(f.confidence, (f.k1 - f.k2) / (f.k1 + std::abs(f.k2)), 1e-12);
  }
}

TEST(ImplicitFrames, SpheresAndPlanesAreUmbilic) {
  RunContext context;
  for (const Expression& e : {sphere(2), box(1, 2, 3)}) {
    const Made m = make(e);
    for (const SurfacePoint& p : m.surface->cover({.count = 50}, context)) {
      const Frame f = m.surface->frame(p);
      EXPECT_TRUE(f.umbilic);
      EXPECT_EQ(f.confidence, 0);
    }
  }
}

TEST(ImplicitMarch, ALineOfCurvatureOfATorusIsItsCircle) {
  const Made m = make(torus(3, 1));
  RunContext context;
  double worst = 0;
  for (const SurfacePoint& start : m.surface->cover({.count = 20}, context)) {
    // The meridian: second order, half a step first; a step is an eightieth of the radius.
    SurfacePoint p = start;
    Vec3 t = m.surface->frame(p).d1;
    const Vec3 axis = glm::normalize(Vec3(-p.position.y, p.position.x, 0));
    for (int i = 0; i < 600; ++i) {
      const auto direction = [&](const SurfacePoint& at, Vec3 along) {
        const Vec3 d = m.surface->frame(at).d1;
        return glm::dot(d, along) < 0 ? -d : d;
      };
      const Vec3 from = m.surface->frame(p).normal;
      const MarchStep half = m.surface->march(p, t, 0.5 / 80);
      const Frame middle = m.surface->frame(half.end);
      const Vec3 d = transport(direction(half.end, half.direction), middle.normal, from);
      const MarchStep step = m.surface->march(p, d, 1.0 / 80);
      ASSERT_EQ(step.stop, MarchStop::Completed);
      p = step.end;
      t = direction(p, step.direction);
      worst = std::max(worst, std::abs(glm::dot(p.position, axis)));
    }
  }
  EXPECT_LT(worst, 1e-6 * 8);
}

TEST(ImplicitMarch, GreatCirclesClose) {
  const Made m = make(translate(sphere(2), {10, 20, 30}));
  RunContext context;
  for (const SurfacePoint& p : m.surface->cover({.count = 20}, context)) {
    const Frame f = m.surface->frame(p);
    const MarchStep step = m.surface->march(p, f.d1 + 0.3 * f.d2, 4 * std::numbers::pi);
    EXPECT_EQ(step.stop, MarchStop::Completed);
    EXPECT_LT(glm::distance(step.end.position, p.position), 1e-5);
  }
}

TEST(ImplicitMarch, StopsExactlyAtCreases) {
  const Made m = make(box(2, 4, 6));
  RunContext context;
  int stopped = 0;
  for (const SurfacePoint& p : m.surface->cover({.count = 100}, context)) {
    const Frame f = m.surface->frame(p);
    const MarchStep step = m.surface->march(p, f.d1, 10);
    ASSERT_EQ(step.stop, MarchStop::Crease);
    const Vec3 q = glm::abs(step.end.position) - Vec3(1, 2, 3);
    int on = 0;
    for (int i = 0; i < 3; ++i) on += std::abs(q[i]) < 1e-7;
    stopped += on == 2;
    EXPECT_NEAR(step.length, glm::distance(p.position, step.end.position), 1e-9);
    // Outwards from there it goes no further; back it does.
    EXPECT_LT(m.surface->march(step.end, step.direction, 1).length, 1e-6);
    EXPECT_NEAR(m.surface->march(step.end, -step.direction, 0.01).length, 0.01, 1e-9);
  }
  EXPECT_EQ(stopped, 100);
}

}  // namespace
}  // namespace burin
