/// The Delaunay mesher of implicit forms: components, creases, sizes, and functions that it cannot
/// mesh.

#include <burin/base/error.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <numbers>
#include <thread>

namespace burin {
namespace {

using namespace implicit;

struct Meshed {
  std::shared_ptr<const ImplicitFunction> function;
  std::shared_ptr<const Surface> surface;
  Diagnostics diagnostics;
  const ProxyMesh& proxy() const { return surface->proxy(); }
};

Meshed refine(const Expression& e, double tolerance, std::optional<Box3> domain = {},
              const ImplicitProxyOptions& options = {Mesher::Delaunay}) {
  RunContext context;
  Meshed m;
  m.function = make_function(e);
  const ImplicitForm form(m.function, domain, context, 0, options);
  RealiseOptions realise;
  realise.tolerance = tolerance;
  realise.diagnostics = &m.diagnostics;
  m.surface = form.realise(realise, context);
  return m;
}

long euler(const ProxyMesh& p) {
  return static_cast<long>(p.mesh.positions.size()) -
         static_cast<long>(p.mesh.triangles.size()) / 2;
}

bool has(const Diagnostics& d, const std::string& code) {
  return std::any_of(d.entries().begin(), d.entries().end(),
                     [&](const Diagnostic& e) { return e.code == code; });
}

double volume(const TriMesh& m) {
  double v = 0;
  for (const Triangle& t : m.triangles) {
    v += glm::dot(m.positions[t[0]], glm::cross(m.positions[t[1]], m.positions[t[2]])) / 6;
  }
  return v;
}

/// Made by refinement, closed, facing outwards, and all vertices on f = 0 within 1e-9 of the size.
void expect_sound(const Meshed& m) {
  const ProxyMesh& p = m.proxy();
  EXPECT_FALSE(has(m.diagnostics, "implicit.delaunay_failed"));
  const double size = p.mesh.bounds().diagonal();
  for (const HalfEdge o : p.topology.opposite) ASSERT_NE(o, kNoHalfEdge);
  for (const Vec3& v : p.mesh.positions) {
    const Gradient1 g = m.function->gradient(v);
    ASSERT_LE(std::abs(g.value), 1e-9 * size * glm::length(g.gradient));
  }
  EXPECT_GT(volume(p.mesh), 0);
}

double least_angle(const TriMesh& m) {
  double least = 180;
  for (const Triangle& t : m.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 p = m.positions[t[k]], u = glm::normalize(m.positions[t[(k + 1) % 3]] - p),
                 v = glm::normalize(m.positions[t[(k + 2) % 3]] - p);
      least = std::min(least,
                       std::acos(std::clamp(glm::dot(u, v), -1.0, 1.0)) * 180 / std::numbers::pi);
    }
  }
  return least;
}

TEST(ImplicitDelaunay, ATorusHasEvenTriangles) {
  const Meshed m = refine(torus(3, 1), 0.01);
  expect_sound(m);
  EXPECT_EQ(euler(m.proxy()), 0);
  EXPECT_GT(least_angle(m.proxy().mesh), 24);
  EXPECT_LE(m.proxy().tolerance, 0.02);
  EXPECT_TRUE(m.diagnostics.empty());
  EXPECT_NEAR(volume(m.proxy().mesh), 6 * std::numbers::pi * std::numbers::pi,
              0.01 * 12 * std::numbers::pi * std::numbers::pi);
}

TEST(ImplicitDelaunay, ACubeMinusABallHasItsTrueEdges) {
  const Meshed m = refine(subtract(box(2, 2, 2), sphere(1.2)), 0.005);
  expect_sound(m);
  const ProxyMesh& p = m.proxy();
  EXPECT_EQ(euler(p), -8);
  EXPECT_EQ(p.region_count, 7);
  double edges = 0, rims = 0;
  for (std::size_t h = 0; h < p.edge_kind.size(); ++h) {
    EXPECT_NE(p.edge_kind[h], EdgeKind::ConcaveCrease);
    if (p.edge_kind[h] != EdgeKind::ConvexCrease) continue;
    const auto e = static_cast<HalfEdge>(h);
    const Vec3 a = p.mesh.positions[origin(p.mesh, e)],
               b = p.mesh.positions[origin(p.mesh, next_in_face(e))];
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
  const double rim = 6 * 2 * std::numbers::pi * std::sqrt(1.44 - 1);
  EXPECT_LT(rims, rim);
  EXPECT_GT(rims, 0.99 * rim);  // chords
}

TEST(ImplicitDelaunay, AllOfManyBodiesAreFound) {
  Expression balls = sphere(0.4);
  for (int i = 1; i < 27; ++i) {
    balls = unite(balls, translate(sphere(0.4), Vec3(i % 3, i / 3 % 3, i / 9)));
  }
  const Meshed m = refine(balls, 0.02);
  expect_sound(m);
  EXPECT_EQ(m.proxy().topology.component_closed.size(), 27u);
  EXPECT_EQ(euler(m.proxy()), 54);
}

TEST(ImplicitDelaunay, ATinyBallBesideALargeOneIsFound) {
  const Meshed m = refine(unite(sphere(1), translate(sphere(1.0 / 32), {1.1, 0, 0})), 0.005);
  expect_sound(m);
  EXPECT_EQ(m.proxy().topology.component_closed.size(), 2u);
  EXPECT_EQ(euler(m.proxy()), 4);
}

TEST(ImplicitDelaunay, InnerHollowsAreFound) {
  const Meshed m = refine(shell(sphere(1), 0.1), 0.02);
  expect_sound(m);
  EXPECT_EQ(m.proxy().topology.component_closed.size(), 2u);
  const auto ball = [](double r) { return 4 * std::numbers::pi / 3 * r * r * r; };
  EXPECT_NEAR(volume(m.proxy().mesh), ball(1.05) - ball(0.95), 0.01);
}

TEST(ImplicitDelaunay, ThinPlatesHaveTwoFaces) {
  const Meshed m = refine(box(4, 4, 0.1), 0.01);
  expect_sound(m);
  EXPECT_EQ(euler(m.proxy()), 2);
  EXPECT_EQ(m.proxy().region_count, 6);
  EXPECT_NEAR(volume(m.proxy().mesh), 1.6, 1e-9);
}

TEST(ImplicitDelaunay, TrianglesAreSmallWhereTheSurfaceBends) {
  // A ball of a tenth of the size on a large one: a hundred times the curvature squared.
  const Expression e = unite(sphere(10), translate(sphere(1), {10.9, 0, 0}));
  const Meshed m = refine(e, 0.01);
  expect_sound(m);
  double large = 0, small = 1e9;
  for (const Triangle& t : m.proxy().mesh.triangles) {
    const Vec3 a = m.proxy().mesh.positions[t[0]], b = m.proxy().mesh.positions[t[1]];
    if (a.x < -5) large = std::max(large, glm::distance(a, b));
    if (a.x > 11.2) small = std::min(small, glm::distance(a, b));
  }
  EXPECT_GT(large, 3 * small);
  EXPECT_LE(m.proxy().tolerance, 0.02);
  EXPECT_LT(m.proxy().mesh.triangles.size(), 12'000u);
}

TEST(ImplicitDelaunay, TheSameBytesEveryTime) {
  const Expression shape = subtract(box(2, 2, 2), sphere(1.2));
  const Meshed a = refine(shape, 0.01), b = refine(shape, 0.01);
  EXPECT_EQ(a.proxy().mesh.positions, b.proxy().mesh.positions);
  EXPECT_EQ(a.proxy().mesh.triangles, b.proxy().mesh.triangles);
}

TEST(ImplicitDelaunay, ScaleAndPlaceDoNotMatter) {
  const Expression shape = subtract(box(2, 2, 2), sphere(1.2));
  for (const double s : {1e-3, 1e4}) {
    const Meshed m = refine(scale(shape, s), 0.01 * s);
    EXPECT_FALSE(has(m.diagnostics, "implicit.delaunay_failed"));
    EXPECT_EQ(euler(m.proxy()), -8);
    EXPECT_EQ(m.proxy().region_count, 7);
  }
  const Meshed far = refine(translate(shape, {1e5, -1e5, 1e5}), 0.01);
  EXPECT_FALSE(has(far.diagnostics, "implicit.delaunay_failed"));
  EXPECT_EQ(euler(far.proxy()), -8);
}

TEST(ImplicitDelaunay, EndlessSurfacesAreClipped) {
  const Meshed m = refine(plane(0.3, 0.2, 1, 0.1), 0.01, Box3{{-1, -2, -3}, {1, 2, 3}});
  EXPECT_TRUE(has(m.diagnostics, "implicit.clipped"));
  EXPECT_FALSE(has(m.diagnostics, "implicit.delaunay_failed"));
  for (const HalfEdge o : m.proxy().topology.opposite) ASSERT_NE(o, kNoHalfEdge);
  EXPECT_EQ(m.proxy().region_count, 6);
}

TEST(ImplicitDelaunay, ItsBoundMakesTrianglesLargerAndIsTold) {
  const Meshed m = refine(torus(3, 1), 1e-5, {}, {Mesher::Delaunay, 5'000});
  expect_sound(m);
  EXPECT_TRUE(has(m.diagnostics, "implicit.proxy_coarse"));
  EXPECT_LT(m.proxy().mesh.triangles.size(), 7'500u);
  EXPECT_EQ(euler(m.proxy()), 0);
}

TEST(ImplicitDelaunay, WithoutEndItGivesUpAndNetsAreUsed) {
  // A pole: the surface is a jump.
  const Meshed m =
      refine(1.0 / Expression::x(), 0.01, Box3{Vec3(-1), Vec3(1)}, {Mesher::Delaunay, 10'000});
  EXPECT_TRUE(has(m.diagnostics, "implicit.not_on_surface"));
  for (const HalfEdge o : m.proxy().topology.opposite) ASSERT_NE(o, kNoHalfEdge);
}

TEST(ImplicitDelaunay, CreasesOverEachOtherEndInNets) {
  // Two cubes that touch along an edge.
  const Expression cube = box(10, 10, 10);
  const Meshed m = refine(unite(cube, translate(cube, {10, 10, 0})), 0.01);
  EXPECT_TRUE(has(m.diagnostics, "implicit.delaunay_failed"));
  for (const HalfEdge o : m.proxy().topology.opposite) ASSERT_NE(o, kNoHalfEdge);
}

TEST(ImplicitDelaunay, NotANumberIsOutside) {
  // A ball of which all with x > 0.5 is not defined.
  const Expression x = Expression::x();
  const Expression half = sphere(1) + 0.0 * implicit::sqrt(0.5 - x);
  const Meshed m = refine(half, 0.02, Box3{Vec3(-1.5), Vec3(1.5)}, {Mesher::Delaunay, 20'000});
  for (const HalfEdge o : m.proxy().topology.opposite) ASSERT_NE(o, kNoHalfEdge);
  for (const Vec3& p : m.proxy().mesh.positions) EXPECT_LT(p.x, 0.6);
}

TEST(ImplicitDelaunay, FunctionsWithoutASurfaceAreRefused) {
  const Box3 cube{Vec3(-1), Vec3(1)};
  EXPECT_THROW(refine(sphere(1) + 2.0, 0.01), GeometryError);
  EXPECT_THROW(refine(Expression(0.0), 0.01, cube), GeometryError);
  EXPECT_THROW(refine(sphere(9), 0.01, cube), GeometryError);
}

TEST(ImplicitDelaunay, ACancelledRunEndsAtOnce) {
  RunContext context;
  const ImplicitForm form(make_function(torus(3, 1)), std::nullopt, context, 0, {Mesher::Delaunay});
  std::thread stop([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    context.cancel();
  });
  RealiseOptions realise;
  realise.tolerance = 1e-5;  // some ten seconds
  EXPECT_THROW(form.realise(realise, context), Cancelled);
  stop.join();
}

TEST(ImplicitDelaunay, ItIsTakenWhereNetsWouldBeTooCoarse) {
  // A cube with half a ball on it, which alone is bent.
  const Expression e = unite(box(20, 20, 20), translate(sphere(3), {10, 0, 0}));
  const ImplicitProxyOptions automatic{Mesher::Auto, 100'000};
  EXPECT_EQ(refine(e, 0.05, {}, automatic).proxy().mesh.triangles,
            refine(e, 0.05, {}, {Mesher::Nets, 100'000}).proxy().mesh.triangles);
  const Meshed fine = refine(e, 0.001, {}, automatic),
               nets = refine(e, 0.001, {}, {Mesher::Nets, 100'000});
  EXPECT_FALSE(has(fine.diagnostics, "implicit.proxy_coarse"));
  EXPECT_TRUE(has(nets.diagnostics, "implicit.proxy_coarse"));
  EXPECT_LT(fine.proxy().mesh.triangles.size(), nets.proxy().mesh.triangles.size() / 2);
  EXPECT_LT(fine.proxy().tolerance, nets.proxy().tolerance);
}

}  // namespace
}  // namespace burin
