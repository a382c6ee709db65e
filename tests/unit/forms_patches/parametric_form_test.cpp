// Untrimmed patches: what coincides is one, and the triangles keep to their tolerance.

#include <burin/forms/patches/parametric_form.h>

#include <burin_test/charts.h>
#include <burin_test/nurbs_shapes.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace burin {
namespace {

using test::kPi;
using ChartPtr = std::shared_ptr<const Chart>;

struct Realised {
  std::shared_ptr<const Surface> surface;
  RunContext context;

  explicit Realised(std::vector<ChartPtr> patches, double tolerance = 0.01) {
    surface = ParametricForm(std::move(patches)).realise({.tolerance = tolerance}, context);
  }
  const ProxyMesh& proxy() const { return surface->proxy(); }
  std::size_t open_sides() const {
    std::size_t n = 0;
    for (const HalfEdge h : proxy().topology.opposite) n += h == kNoHalfEdge;
    return n;
  }
  std::size_t creases() const {
    std::size_t n = 0;
    for (std::size_t h = 0; h < proxy().edge_kind.size(); ++h) {
      n += proxy().is_crease(static_cast<HalfEdge>(h));
    }
    return n;
  }
  /// Edges of the input that the proxy knows, and those that are seams.
  std::set<std::int32_t> edges(bool seams) const {
    std::set<std::int32_t> found;
    for (std::size_t h = 0; h < proxy().source_edge.size(); ++h) {
      if (proxy().source_edge[h] >= 0 && (proxy().seam[h] != 0) == seams) {
        found.insert(proxy().source_edge[h]);
      }
    }
    return found;
  }
  double volume() const {
    double v = 0;
    for (const Triangle& t : proxy().mesh.triangles) {
      const auto& p = proxy().mesh.positions;
      v += glm::dot(p[t[0]], glm::cross(p[t[1]], p[t[2]])) / 6;
    }
    return v;
  }
  int euler() const {
    std::size_t half = 0, open = open_sides();
    half = 3 * proxy().mesh.triangles.size();
    const auto e = static_cast<int>((half + open) / 2);
    return static_cast<int>(proxy().mesh.positions.size()) - e +
           static_cast<int>(proxy().mesh.triangles.size());
  }
};

/// The part of a chart over a rectangle, its parameters scaled by `speed` (u -> u^speed), turned
/// round where asked.
ChartPtr piece(const ChartPtr& whole, Vec2 min, Vec2 max, bool swap = false, double speed = 1) {
  return make_function_chart(
      [=](Vec2 p) {
        Vec2 q = swap ? Vec2(p.y, p.x) : p;
        q.x = std::pow(q.x, speed);
        return whole->position(min + q * (max - min));
      },
      {{Vec2(0), Vec2(1)}, Vec2(0)});
}

TEST(ParametricForm, ATorusClosesOverItsSeams) {
  const Realised r({test::torus_chart(3, 1)});
  EXPECT_EQ(r.open_sides(), 0u);
  EXPECT_EQ(r.creases(), 0u);
  EXPECT_EQ(r.euler(), 0);
  EXPECT_EQ(r.edges(true).size(), 2u);
  EXPECT_TRUE(r.edges(false).empty());
  EXPECT_LE(r.proxy().tolerance, 0.02);
  EXPECT_NEAR(r.volume(), 6 * kPi * kPi, 0.01 * 12 * kPi * kPi);
  EXPECT_LT(r.proxy().mesh.triangles.size(), 8000u);
}

TEST(ParametricForm, CollapsedSidesArePoles) {
  const Realised r({test::ellipsoid_chart(Vec3(2))});
  EXPECT_EQ(r.open_sides(), 0u);
  EXPECT_EQ(r.creases(), 0u);
  EXPECT_EQ(r.euler(), 2);
  EXPECT_EQ(r.edges(true).size(), 1u);
  EXPECT_LE(r.proxy().tolerance, 0.02);
  EXPECT_NEAR(r.volume(), 32 * kPi / 3, 0.01 * 16 * kPi);
  for (std::size_t w = 0; w < r.proxy().wedge_normal.size(); ++w) {
    const Vec3 p = r.proxy().wedge_position(static_cast<std::uint32_t>(w));
    EXPECT_LT(glm::distance(r.proxy().wedge_normal[w], p / 2.0), 1e-9);
  }
}

TEST(ParametricForm, TinyHolesAtPolesAreClosed) {
  NurbsData ball = test::sphere_nurbs(2);
  for (int i = 1; i + 1 < ball.count_u; ++i) {
    Vec3& p = ball.points[static_cast<std::size_t>(i * ball.count_v)];
    p += Vec3(3e-4 * std::sin(i), 3e-4 * std::cos(i), 0);
  }
  const Realised r({make_nurbs_chart(ball)});
  EXPECT_EQ(r.open_sides(), 0u);
  EXPECT_EQ(r.euler(), 2);
}

TEST(ParametricForm, PatchesWeldWhicheverWayTheyRun) {
  const Realised r(test::six_patches(Vec3(1)));
  EXPECT_EQ(r.open_sides(), 0u);
  EXPECT_EQ(r.creases(), 0u);
  EXPECT_EQ(r.euler(), 2);
  EXPECT_EQ(r.edges(true).size(), 12u);  // they divide one sphere
  EXPECT_TRUE(r.edges(false).empty());
  EXPECT_NEAR(r.volume(), 4 * kPi / 3, 4 * kPi * 0.01);
  EXPECT_GT(r.volume(), 0);
}

TEST(ParametricForm, SidesOfDifferentSpeedAreOneEdge) {
  const ChartPtr whole = test::torus_chart(3, 1);
  // Two quarters of a tube that share the arc v = 1, run through at other speeds.
  const Realised r({piece(whole, {0, 0}, {1.5, 1}), piece(whole, {0, 1}, {1.5, 2}, true, 1.5)});
  EXPECT_EQ(r.creases(), 0u);
  EXPECT_EQ(r.euler(), 1);
  EXPECT_EQ(r.edges(false).size(), 6u);
  EXPECT_EQ(r.edges(true).size(), 1u);
  EXPECT_LE(r.proxy().tolerance, 0.02);
  // A march over the common edge goes on as on the whole torus.
  for (int i = 0; i < 20; ++i) {
    const ProxyPoint place{static_cast<std::uint32_t>(7 * i), Vec3(1.0 / 3)};
    const SurfacePoint p = r.surface->lift(place);
    const Frame f = r.surface->frame(p);
    const Vec3 t = f.normal.z > 0.9 ? f.d1 : f.d2;
    const MarchStep there = r.surface->march(p, t, 0.8);
    const MarchStep back = r.surface->march(there.end, -there.direction, there.length);
    EXPECT_LT(glm::distance(back.end.position, p.position), 1e-6);
  }
}

TEST(ParametricForm, AMarchOverSixPatchesIsAGreatCircle) {
  const Realised r(test::six_patches(Vec3(1)));
  const RunContext context;
  for (const SurfacePoint& p : r.surface->cover({.count = 200}, context)) {
    const Frame f = r.surface->frame(p);
    const Vec3 t = glm::normalize(f.d1 + 0.37 * f.d2);
    const MarchStep m = r.surface->march(p, t, 5);
    ASSERT_EQ(m.stop, MarchStop::Completed);
    const Vec3 truth = std::cos(5.0) * p.position + std::sin(5.0) * t;
    EXPECT_LT(glm::distance(m.end.position, truth), 1e-6);
  }
}

TEST(ParametricForm, EdgesOfABoxAreSharpAndStopMarches) {
  const Realised r(test::box_patches(Vec3(1)));
  EXPECT_EQ(r.open_sides(), 0u);
  EXPECT_EQ(r.euler(), 2);
  EXPECT_NEAR(r.volume(), 1, 1e-12);
  EXPECT_EQ(r.edges(false).size(), 12u);
  for (std::size_t h = 0; h < r.proxy().edge_kind.size(); ++h) {
    const bool edge = r.proxy().source_edge[h] >= 0;
    EXPECT_EQ(r.proxy().edge_kind[h] == EdgeKind::ConvexCrease, edge);
  }
  const RunContext context;
  for (const SurfacePoint& p : r.surface->cover({.count = 50}, context)) {
    const MarchStep m = r.surface->march(p, Vec3(0.3, 0.5, 0.2), 5);
    ASSERT_EQ(m.stop, MarchStop::Crease);
    int extremes = 0;
    for (int i = 0; i < 3; ++i) {
      extremes += std::min(m.end.position[i], 1 - m.end.position[i]) < 1e-12;
    }
    EXPECT_GE(extremes, 2);
  }
}

TEST(ParametricForm, AKinkInsideAPatchIsASharpEdge) {
  // A roof: degree 1 along u with a knot in the middle.
  NurbsData roof;
  roof.degree_u = roof.degree_v = 1;
  roof.count_u = 3;
  roof.count_v = 2;
  roof.knots_u = {0, 0, 0.5, 1, 1};
  roof.knots_v = {0, 0, 1, 1};
  for (const Vec2 p : {Vec2(0, 0), Vec2(1, 1), Vec2(2, 0)}) {
    roof.points.push_back({p.x, 0, p.y});
    roof.points.push_back({p.x, 3, p.y});
  }
  const Realised r({make_nurbs_chart(roof)});
  EXPECT_EQ(r.euler(), 1);
  EXPECT_GT(r.creases(), 0u);
  for (std::size_t h = 0; h < r.proxy().edge_kind.size(); ++h) {
    if (!r.proxy().is_crease(static_cast<HalfEdge>(h))) continue;
    EXPECT_NEAR(r.proxy().mesh.positions[origin(r.proxy().mesh, static_cast<HalfEdge>(h))].x, 1,
                1e-12);
    EXPECT_EQ(r.proxy().edge_kind[h], EdgeKind::ConvexCrease);
  }
}

TEST(ParametricForm, AMoebiusStripStaysOpenAndSaysSo) {
  const auto strip = make_function_chart(
      [](Vec2 p) {
        const double u = p.x, v = p.y;
        const double r = 2 + v * std::cos(u / 2);
        return Vec3(r * std::cos(u), r * std::sin(u), v * std::sin(u / 2));
      },
      {{{0, -0.5}, {2 * kPi, 0.5}}, Vec2(0)});
  RunContext context;
  Diagnostics diagnostics;
  const auto s =
      ParametricForm({strip}).realise({.tolerance = 0.01, .diagnostics = &diagnostics}, context);
  ASSERT_EQ(diagnostics.entries().size(), 1u);
  EXPECT_EQ(diagnostics.entries()[0].code, "parametric.one_sided");
  EXPECT_GT(s->proxy().mesh.triangles.size(), 0u);
}

TEST(ParametricForm, BoundsAreTight) {
  const ParametricForm form({test::torus_chart(3, 1)});
  const Box3 b = form.bounds(Mat3(1));
  EXPECT_LT(glm::distance(b.min, Vec3(-4, -4, -1)), 1e-8);
  EXPECT_LT(glm::distance(b.max, Vec3(4, 4, 1)), 1e-8);
  const Vec3 x = glm::normalize(Vec3(1, 2, 2));
  const Mat3 axes = glm::transpose(Mat3(x, Vec3(0, 1, 0), Vec3(0, 0, 1)));
  const double truth = 3 * std::hypot(x.x, x.y) + 1;
  EXPECT_NEAR(form.bounds(axes).max.x, truth, 1e-7);
  EXPECT_NEAR(form.bounds(axes).min.x, -truth, 1e-7);
}

TEST(ParametricForm, ScaleAndPlaceChangeNothing) {
  const Realised one(test::six_patches(Vec3(1)), 0.01), small(test::six_patches(Vec3(1e-3)), 1e-5);
  EXPECT_EQ(one.proxy().mesh.triangles, small.proxy().mesh.triangles);
}

}  // namespace
}  // namespace burin
