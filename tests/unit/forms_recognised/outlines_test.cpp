// Walls over an outline that bends, in meshes of which nothing is known.

#include <burin/base/diagnostics.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/repair/repair.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace burin {
namespace {

using Outline = std::vector<Vec2>;

/// Points of a curve as an STL has them, at `count` equal steps of its parameter in [0, 1).
Outline sampled(int count, const std::function<Vec2(double)>& curve) {
  Outline out;
  for (int i = 0; i < count; ++i) out.push_back(curve(static_cast<double>(i) / count));
  return out;
}
Vec2 ellipse_point(double t) {
  return {20 * std::cos(2 * test::kPi * t), 10 * std::sin(2 * test::kPi * t)};
}

/// An outline from z = 0 up to `top(p)`, in the digits that STL files have.
RecognisedForm extruded_outline(const Outline& outline, const std::function<double(Vec2)>& top) {
  PolygonSoup soup;
  const auto add = [&](const std::vector<Vec3>& polygon) {
    for (const Vec3& p : polygon) {
      soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
      soup.positions.push_back(
          Vec3(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)));
    }
    soup.offsets.push_back(soup.indices.size());
  };
  std::vector<Vec3> above, below;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 p = outline[i], q = outline[(i + 1) % outline.size()];
    add({{p.x, p.y, 0}, {q.x, q.y, 0}, {q.x, q.y, top(q)}, {p.x, p.y, top(p)}});
    above.emplace_back(p.x, p.y, top(p));
    below.insert(below.begin(), {p.x, p.y, 0});
  }
  add(above);
  add(below);
  Diagnostics diagnostics;
  return {repair(std::move(soup), {}, diagnostics, RunContext()), RunContext()};
}
double ten(Vec2) { return 10; }

std::shared_ptr<const Surface> realised(const RecognisedForm& form) {
  RunContext context;
  return form.realise({.tolerance = 0.01}, context);
}

/// Edges of walls that are upright: what would be a line within a wall.
int upright_edges(const ProxyMesh& proxy) {
  int count = 0;
  for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
    const HalfEdge o = proxy.topology.opposite[h];
    if (o == kNoHalfEdge || o < static_cast<HalfEdge>(h)) continue;
    const Vec3 along = proxy.mesh.positions[origin(proxy.mesh, o)] -
                       proxy.mesh.positions[origin(proxy.mesh, static_cast<HalfEdge>(h))];
    const bool line = proxy.edge_kind[h] != EdgeKind::Smooth || proxy.source_edge[h] >= 0;
    if (line && std::hypot(along.x, along.y) < 1e-3 * std::abs(along.z)) ++count;
  }
  return count;
}

TEST(OutlineWalls, AnEllipseIsOneSurfaceOnTheEllipse) {
  for (const int sides : {24, 48, 96}) {
    const RecognisedForm form = extruded_outline(sampled(sides, ellipse_point), ten);
    EXPECT_EQ(form.faces().swept, 1) << sides;
    EXPECT_EQ(form.faces().total(), 1) << sides;
    const auto surface = realised(form);
    EXPECT_EQ(upright_edges(surface->proxy()), 0) << sides;
    const double chord = 10 * (1 - std::cos(test::kPi / sides));  // of the flatter side
    for (const Vec3& p : surface->proxy().mesh.positions) {
      if (p.z < 1e-3 || p.z > 10 - 1e-3) {
        EXPECT_LT(std::abs(std::hypot(p.x / 20, p.y / 10) - 1) * 10, 0.2 * chord) << sides;
      }
    }
  }
}

TEST(OutlineWalls, RimsMayBeCutInAnyWay) {
  // A roof over the ellipse: every wall is of another height.
  const RecognisedForm form = extruded_outline(sampled(48, ellipse_point),
                                               [](Vec2 p) { return 12 + 0.3 * p.x + 0.1 * p.y; });
  EXPECT_EQ(form.faces().swept, 1);
  EXPECT_EQ(upright_edges(realised(form)->proxy()), 0);
}

TEST(OutlineWalls, AnEdgeThatAnOutlineHasStays) {
  // A wing: smooth around its nose, an edge behind.
  const RecognisedForm wing =
      extruded_outline(sampled(40,
                               [](double t) {
                                 const double a = 2 * test::kPi * t;
                                 const double x = 0.5 * (1 + std::cos(a));
                                 return Vec2(60 * x, 12 * std::sin(a) * (1 - x));
                               }),
                       ten);
  EXPECT_EQ(wing.faces().swept, 1);
  EXPECT_EQ(upright_edges(realised(wing)->proxy()), 1);
}

TEST(OutlineWalls, CirclesStayCylindersAndPrismsPrisms) {
  const RecognisedForm disc = extruded_outline(
      sampled(24,
              [](double t) {
                return 10.0 * Vec2(std::cos(2 * test::kPi * t), std::sin(2 * test::kPi * t));
              }),
      ten);
  EXPECT_EQ(disc.faces().cylinders, 1);
  EXPECT_EQ(disc.faces().total(), 1);
  EXPECT_EQ(extruded_outline({{0, 0}, {20, 0}, {22, 8}, {10, 14}, {0, 9}}, ten).faces().total(), 0);
}

TEST(OutlineWalls, ThreeFacetsAreACylinderWhereTheyEnd) {
  // A quarter of a circle between walls that are tangent to it, or that meet it in edges.
  for (const double lean : {0.0, 1.0}) {
    Outline outline;
    for (int i = 0; i <= 3; ++i) {
      const double a = test::kPi / 6 * i;
      outline.push_back(10.0 * Vec2(std::cos(a), std::sin(a)));
    }
    outline.push_back({-20, 10 - 20 * lean});
    outline.push_back({10 - 20 * lean, -20});
    EXPECT_EQ(extruded_outline(outline, ten).faces().cylinders, 1) << lean;
  }
}

}  // namespace
}  // namespace burin
