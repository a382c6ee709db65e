#include <burin/base/error.h>
#include <burin/base/rng.h>
#include <burin/repair/repair.h>

#include <burin_test/mesh_checks.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace burin {
namespace {

/// One polygon over its points, lifted into space by `place`.
PolygonSoup polygon(const std::vector<Vec2>& outline, const std::function<Vec3(Vec2)>& place) {
  PolygonSoup soup;
  for (const Vec2& p : outline) soup.positions.push_back(place(p));
  soup.indices.resize(outline.size());
  std::iota(soup.indices.begin(), soup.indices.end(), 0u);
  soup.offsets.push_back(outline.size());
  return soup;
}

double area_of(const std::vector<Vec2>& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    sum += cross2(outline[i], outline[(i + 1) % outline.size()]);
  return sum / 2;
}

struct Cut {
  TriMesh mesh;
  Diagnostics diagnostics;
};

Cut cut(PolygonSoup soup) {
  Cut out;
  const RunContext context;
  out.mesh = repair(std::move(soup), {}, out.diagnostics, context);
  return out;
}

/// The triangles cover the outline: areas add up, and each faces the way of the polygon.
void expect_covered(const std::vector<Vec2>& outline, const std::function<Vec3(Vec2)>& place,
                    Vec3 normal, std::size_t triangles, double scale = 1) {
  const Cut c = cut(polygon(outline, place));
  EXPECT_EQ(c.mesh.triangles.size(), triangles);
  EXPECT_EQ(test::count_of(c.diagnostics, "mesh.crossed_polygons"), 0);
  double area = 0;
  for (std::uint32_t t = 0; t < c.mesh.triangles.size(); ++t) {
    area += c.mesh.area(t);
    EXPECT_GT(glm::dot(c.mesh.normal(t), normal), 0.999);
  }
  EXPECT_NEAR(area / (scale * scale), area_of(outline), 1e-8 * area_of(outline));
}

Vec3 flat(Vec2 p) { return {p.x, p.y, 0}; }

/// The diagonal that a quadrilateral is cut along, as its two ends.
std::pair<std::size_t, std::size_t> diagonal(const std::vector<Vec3>& corners, std::size_t first) {
  PolygonSoup soup;
  soup.positions = corners;
  for (std::uint32_t i = 0; i < 4; ++i) {
    soup.indices.push_back(static_cast<std::uint32_t>((first + i) % 4));
  }
  soup.offsets.push_back(4);
  const TriMesh mesh = cut(std::move(soup)).mesh;
  std::vector<int> uses(4, 0);
  const auto index_of = [&](std::uint32_t v) {
    return static_cast<std::size_t>(std::ranges::find(corners, mesh.positions[v]) -
                                    corners.begin());
  };
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++uses[index_of(v)];
  }
  return uses[0] == 2 ? std::pair<std::size_t, std::size_t>{0, 2}
                      : std::pair<std::size_t, std::size_t>{1, 3};
}

TEST(Polygons, CutsOfBentQuadsDoNotDependOnTheFirstCorner) {
  // Diagonals of one length, as in a helicoid or a saddle; a kite, whose longer diagonal folds
  // less.
  const std::vector<Vec3> saddle = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  const std::vector<Vec3> kite = {{0, -0.2, 0}, {1, 0, 0.3}, {0, 2, 0}, {-1, 0, 0.3}};
  for (std::size_t first = 0; first < 4; ++first) {
    EXPECT_EQ(diagonal(saddle, first), diagonal(saddle, 0)) << first;
    EXPECT_EQ(diagonal(kite, first), (std::pair<std::size_t, std::size_t>{0, 2})) << first;
  }
}

TEST(Polygons, ConcaveOutline) {
  // A comb: every second corner is reflex.
  std::vector<Vec2> comb = {{0, 0}, {20, 0}};
  for (int i = 10; i-- > 0;) {
    comb.push_back({2.0 * i + 1.5, 10});
    comb.push_back({2.0 * i + 0.5, 1});
  }
  expect_covered(comb, flat, {0, 0, 1}, comb.size() - 2);
}

TEST(Polygons, InAnyPlaneAndFarFromTheOrigin) {
  const std::vector<Vec2> arrow = {{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}};
  const Vec3 u = glm::normalize(Vec3(1, 2, -0.5)),
             v = glm::normalize(glm::cross(Vec3(0.3, 1, 2), u));
  for (const double scale : {1e-3, 1.0, 1e4}) {
    for (const double away : {0.0, 1e5}) {
      expect_covered(
          arrow, [&](Vec2 p) { return scale * (p.x * u + p.y * v) + Vec3(away); }, glm::cross(u, v),
          3, scale);
      if (scale < 1) break;  // 1e-3 at 1e5 leaves no digits
    }
  }
}

TEST(Polygons, ClockwiseSeenFromAboveFacesDown) {
  const std::vector<Vec2> arrow = {{0, 3}, {2, 1}, {4, 3}, {4, 0}, {0, 0}};
  const Cut c = cut(polygon(arrow, flat));
  for (std::uint32_t t = 0; t < c.mesh.triangles.size(); ++t) EXPECT_LT(c.mesh.normal(t).z, -0.999);
}

TEST(Polygons, CornersOnStraightEdges) {
  const std::vector<Vec2> square = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1},
                                    {3, 3}, {1, 3}, {0, 3}, {0, 1}};
  expect_covered(square, flat, {0, 0, 1}, square.size() - 2);
}

TEST(Polygons, HoleJoinedByABridge) {
  const std::vector<Vec2> ring = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0},
                                  {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};
  expect_covered(ring, flat, {0, 0, 1}, ring.size() - 2);
}

TEST(Polygons, RandomStarsAreCoveredExactly) {
  const Rng rng(11);
  std::uint64_t n = 0;
  for (int k = 0; k < 50; ++k) {
    const int corners = 5 + static_cast<int>(rng.uniform(n++) * 60);
    std::vector<Vec2> star;
    for (int i = 0; i < corners; ++i) {
      const double a = 2 * test::kPi * i / corners, r = 0.1 + rng.uniform(n++);
      star.push_back({r * std::cos(a), r * std::sin(a)});
    }
    expect_covered(star, flat, {0, 0, 1}, star.size() - 2);
  }
}

TEST(Polygons, LongSpiral) {
  std::vector<Vec2> spiral;
  constexpr int kSteps = 400;
  for (int i = 0; i < kSteps; ++i) {
    const double a = 0.1 * i;
    spiral.push_back(Vec2(std::cos(a), std::sin(a)) * (1 + 0.05 * a));
  }
  for (int i = kSteps; i-- > 0;) {
    const double a = 0.1 * i;
    spiral.push_back(Vec2(std::cos(a), std::sin(a)) * (1.1 + 0.05 * a));
  }
  if (area_of(spiral) < 0) std::reverse(spiral.begin(), spiral.end());
  expect_covered(spiral, flat, {0, 0, 1}, spiral.size() - 2);
}

TEST(Polygons, SlightlyBentPolygonKeepsItsOutline) {
  std::vector<Vec2> outline = {{0, 0}, {4, 0}, {4, 3}, {2, 1}, {0, 3}};
  const Cut c = cut(polygon(outline, [](Vec2 p) { return Vec3(p.x, p.y, 0.05 * p.x * p.y); }));
  EXPECT_EQ(c.mesh.triangles.size(), 3u);
  const test::MeshNumbers n = test::numbers(c.mesh);
  EXPECT_EQ(n.boundary_edges, 5);
  EXPECT_EQ(n.euler, 1);
  for (std::uint32_t t = 0; t < 3; ++t) EXPECT_GT(c.mesh.normal(t).z, 0.9);
}

TEST(Polygons, QuadIsCutInside) {
  // The dart's reflex corner is the third: only the cut through it lies inside.
  const Cut c = cut(polygon({{0, 0}, {4, 1}, {1, 1}, {1, 4}}, flat));
  ASSERT_EQ(c.mesh.triangles.size(), 2u);
  for (std::uint32_t t = 0; t < 2; ++t) EXPECT_GT(c.mesh.normal(t).z, 0.99);
}

TEST(Polygons, QuadIsCutByItsShorterDiagonal) {
  const Cut c = cut(polygon({{0, 0}, {1, 0}, {3, 2}, {0, 1}}, flat));
  ASSERT_EQ(c.mesh.triangles.size(), 2u);
  EXPECT_EQ(c.mesh.triangles[0], (Triangle{0, 1, 3}));
  EXPECT_EQ(c.mesh.triangles[1], (Triangle{1, 2, 3}));
}

TEST(Polygons, CrossedPolygonIsReported) {
  const Cut c = cut(polygon({{0, 0}, {4, 0}, {4, 4}, {1, -1}, {0, 4}}, flat));
  EXPECT_EQ(test::count_of(c.diagnostics, "mesh.crossed_polygons"), 1);
  EXPECT_GE(c.mesh.triangles.size(), 1u);
}

TEST(Polygons, WrongSoupsAreRefused) {
  Diagnostics d;
  const RunContext context;
  PolygonSoup out_of_range = polygon({{0, 0}, {1, 0}, {0, 1}}, flat);
  out_of_range.indices[1] = 3;
  EXPECT_THROW(repair(out_of_range, {}, d, context), GeometryError);
  PolygonSoup two = polygon({{0, 0}, {1, 0}}, flat);
  EXPECT_THROW(repair(two, {}, d, context), GeometryError);
  PolygonSoup mismatch = polygon({{0, 0}, {1, 0}, {0, 1}}, flat);
  mismatch.offsets.back() = 7;
  EXPECT_THROW(repair(mismatch, {}, d, context), GeometryError);
  EXPECT_THROW(repair(PolygonSoup{}, {}, d, context), GeometryError);
}

}  // namespace
}  // namespace burin
