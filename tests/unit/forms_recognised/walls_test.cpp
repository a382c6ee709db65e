/// Flat walls of healed parts stay flat, whatever meets them at a small angle.

#include <burin/field/field.h>
#include <burin/forms/recognised/recognised_form.h>
#include <burin/repair/repair.h>

#include <burin_test/fields.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace burin {
namespace {

using Polygon = std::vector<Vec3>;

// What of convex polygons lies below a plane, and the cut.
std::vector<Polygon> cut(const std::vector<Polygon>& solid, Vec3 normal, double offset) {
  std::vector<Polygon> out;
  Polygon cap;
  for (const Polygon& face : solid) {
    Polygon kept;
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Vec3 a = face[i], b = face[(i + 1) % face.size()];
      const double da = glm::dot(normal, a) - offset, db = glm::dot(normal, b) - offset;
      if (da <= 0) kept.push_back(a);
      if ((da < 0) != (db < 0)) {
        // In one order of the ends, so that both faces of an edge get the same point.
        const bool turned = da > db;
        const Vec3 low = turned ? b : a, high = turned ? a : b;
        const double dl = turned ? db : da, dh = turned ? da : db;
        kept.push_back(low + dl / (dl - dh) * (high - low));
        cap.push_back(kept.back());
      }
    }
    if (kept.size() > 2) out.push_back(kept);
  }
  Vec3 middle(0);
  for (const Vec3& p : cap) middle += p / static_cast<double>(cap.size());
  const Vec3 x = any_orthogonal(normal), y = glm::cross(normal, x);
  std::sort(cap.begin(), cap.end(), [&](Vec3 a, Vec3 b) {
    return std::atan2(glm::dot(a - middle, y), glm::dot(a - middle, x)) <
           std::atan2(glm::dot(b - middle, y), glm::dot(b - middle, x));
  });
  Polygon once;
  for (const Vec3& p : cap) {
    if (once.empty() || glm::distance(once.back(), p) > 1e-9) once.push_back(p);
  }
  if (glm::distance(once.front(), once.back()) < 1e-9) once.pop_back();
  out.push_back(once);
  return out;
}

std::vector<Polygon> block(Vec3 size) {
  const double x = size.x, y = size.y, z = size.z;
  return {
      {{0, 0, 0}, {0, y, 0}, {x, y, 0}, {x, 0, 0}}, {{0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z}},
      {{0, 0, 0}, {x, 0, 0}, {x, 0, z}, {0, 0, z}}, {{0, y, 0}, {0, y, z}, {x, y, z}, {x, y, 0}},
      {{0, 0, 0}, {0, 0, z}, {0, y, z}, {0, y, 0}}, {{x, 0, 0}, {x, y, 0}, {x, y, z}, {x, 0, z}}};
}

// A pin beside it, so that there is something to heal.
std::shared_ptr<const Surface> healed(std::vector<Polygon> polygons) {
  const int sides = 24;
  const auto at = [&](int i, double z) {
    const double a = 2 * test::kPi * i / sides;
    return Vec3(-40 + 8 * std::cos(a), 8 * std::sin(a), z);
  };
  Polygon bottom, top;
  for (int i = 0; i < sides; ++i) {
    polygons.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 20), at(i, 20)});
    top.push_back(at(i, 20));
    bottom.push_back(at(sides - i, 0));
  }
  polygons.push_back(top);
  polygons.push_back(bottom);
  PolygonSoup soup;
  for (const Polygon& polygon : polygons) {
    for (const Vec3& p : polygon) {
      soup.indices.push_back(static_cast<std::uint32_t>(soup.positions.size()));
      soup.positions.push_back(
          Vec3(static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)));
    }
    soup.offsets.push_back(soup.indices.size());
  }
  Diagnostics diagnostics;
  const RecognisedForm form(repair(std::move(soup), {}, diagnostics, RunContext()), RunContext());
  EXPECT_EQ(form.faces().cylinders, 1);
  RunContext context;
  return form.realise({.tolerance = 0.01, .curvature = true}, context);
}

// The triangles whose own normal is `normal`.
std::vector<std::uint32_t> facing(const ProxyMesh& proxy, Vec3 normal) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) {
    if (proxy.mesh.area(t) > 0 && glm::distance(proxy.mesh.normal(t), normal) < 1e-5) {
      out.push_back(t);
    }
  }
  return out;
}

void expect_flat(const Surface& s, Vec3 normal) {
  const std::vector<std::uint32_t> wall = facing(s.proxy(), normal);
  ASSERT_FALSE(wall.empty());
  const Field field = field::smoothed({&s}, {}, RunContext());
  std::optional<Vec3> first;
  for (const std::uint32_t t : wall) {
    EXPECT_EQ(s.proxy().source_face[t], s.proxy().source_face[wall.front()]);
    for (const Vec3 bary :
         {Vec3(0.98, 0.01, 0.01), Vec3(0.01, 0.98, 0.01), Vec3(0.01, 0.01, 0.98), Vec3(1.0 / 3)}) {
      const test::Probe p(s, {t, bary});
      EXPECT_LT(glm::distance(p.frame.normal, normal), 1e-5);
      const auto d = test::direction(field, p.query());
      ASSERT_TRUE(d);
      if (!first) first = d;
      EXPECT_LT(test::line_angle(*d, *first), 1e-3) << "strokes are straight";
    }
  }
}

TEST(HealedWalls, StayFlatBesideCutsAcrossTheirCorners) {
  // The walls of a block of 60 mm; two of its corners are cut off, 30 and 27 degrees to one wall.
  std::vector<Polygon> solid = block({60, 60, 60});
  const Vec3 n = glm::normalize(Vec3(0.87, 0.41, 0.28)),
             m = glm::normalize(Vec3(0.89, -0.38, 0.23));
  ASSERT_GT(n.x, std::cos(30 * test::kPi / 180));
  solid = cut(solid, n, glm::dot(n, Vec3(60, 52, 60)));
  solid = cut(solid, m, glm::dot(m, Vec3(60, 6, 60)));
  const auto s = healed(solid);
  expect_flat(*s, {1, 0, 0});
  expect_flat(*s, n);
  expect_flat(*s, m);
  // The edges of a cut are edges.
  for (const std::uint32_t t : facing(s->proxy(), n)) {
    for (std::size_t h = 3 * t; h < 3 * t + 3; ++h) {
      const HalfEdge o = s->proxy().topology.opposite[h];
      const bool inside = s->proxy().source_face[face_of(o)] == s->proxy().source_face[t];
      EXPECT_EQ(s->proxy().edge_kind[h] == EdgeKind::Smooth, inside);
    }
  }
}

TEST(HealedWalls, StayFlatWhereSomethingUnknownBendsAwayFromThem) {
  // A wall of 80 mm that ends in a quarter of an elliptic cone, which nothing recognises.
  std::vector<Vec2> outline{{0, 0}, {80, 0}};
  constexpr int kSteps = 12;
  for (int i = 1; i <= kSteps; ++i) {
    const double a = 0.5 * test::kPi * i / kSteps;
    outline.push_back({80 + 20 * std::sin(a), 12 * (1 - std::cos(a))});
  }
  outline.push_back({100, 40});
  outline.push_back({0, 40});
  // The tip of the cone is at (80, 0, 60).
  const auto on_top = [](Vec2 p) {
    return Vec3(p.x <= 80 ? p.x : 0.5 * (80 + p.x), p.y < 40 ? 0.5 * p.y : 40, 30);
  };
  std::vector<Polygon> solid;
  Polygon top, bottom;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 p = outline[i], q = outline[(i + 1) % outline.size()];
    solid.push_back({{p.x, p.y, 0}, {q.x, q.y, 0}, on_top(q), on_top(p)});
    top.push_back(on_top(p));
    bottom.insert(bottom.begin(), {p.x, p.y, 0});
  }
  solid.push_back(top);
  solid.push_back(bottom);
  const auto s = healed(solid);
  expect_flat(*s, {0, -1, 0});
  // No edge is drawn where the wall goes over into the bend, whose normals begin with the wall's.
  int smooth = 0;
  for (const std::uint32_t t : facing(s->proxy(), {0, -1, 0})) {
    for (std::size_t h = 3 * t; h < 3 * t + 3; ++h) {
      const std::uint32_t other = face_of(s->proxy().topology.opposite[h]);
      if (s->proxy().source_face[other] == s->proxy().source_face[t]) continue;
      if (s->proxy().edge_kind[h] != EdgeKind::Smooth) continue;
      ++smooth;
      EXPECT_EQ(s->proxy().source_edge[h], -1);
    }
  }
  EXPECT_EQ(smooth, 1);
}

}  // namespace
}  // namespace burin
