// Smooth surfaces through rows of points.

#include <burin/forms/recognised/recognised_form.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace burin {
namespace {

using test::kPi;

using Point = std::function<Vec3(int row, int column)>;

PointGrid grid_of(int rows, int columns, bool closes, const Point& point) {
  PointGrid g;
  g.rows = rows;
  g.columns = columns;
  g.columns_close = closes;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) g.points.push_back(point(j, i));
  }
  return g;
}

/// An outline, extruded by 10 mm, turned by `twist` radians over its height.
PointGrid extruded(const std::vector<Vec2>& outline, int rows = 2, double twist = 0) {
  return grid_of(rows, static_cast<int>(outline.size()), true, [&](int j, int i) {
    const Vec2 p = outline[static_cast<std::size_t>(i)];
    const double share = double(j) / (rows - 1), a = twist * share;
    return Vec3(std::cos(a) * p.x - std::sin(a) * p.y, std::sin(a) * p.x + std::cos(a) * p.y,
                10 * share);
  });
}

std::vector<Vec2> star(int corners, double outer, double inner) {
  std::vector<Vec2> out;
  for (int i = 0; i < corners; ++i) {
    const double a = 2 * kPi * i / corners, r = i % 2 == 0 ? outer : inner;
    out.push_back(r * Vec2(std::cos(a), std::sin(a)));
  }
  return out;
}
std::vector<Vec2> ellipse(int corners, double a, double b) {
  std::vector<Vec2> out;
  for (int i = 0; i < corners; ++i) {
    const double t = 2 * kPi * i / corners;
    out.emplace_back(a * std::cos(t), b * std::sin(t));
  }
  return out;
}

/// The grid's cells, closed below and above by fans where it is closed all round.
RecognisedForm form_of(const PointGrid& grid) {
  SmoothGrids smooth = smooth_grids(grid, Rows::Steps);
  TriMesh mesh;
  mesh.positions = grid.points;
  KnownSurfaces known;
  for (PointGrid& piece : smooth.pieces) {
    TurnedSurface t;
    t.profile = TurnedSurface::Profile::Grid;
    t.grid = std::make_shared<const PointGrid>(std::move(piece));
    known.surfaces.push_back(std::move(t));
  }
  const auto number = [&](std::int32_t j, std::int32_t i) {
    return static_cast<std::uint32_t>(j * grid.columns + i % grid.columns);
  };
  for (std::int32_t j = 0; j < grid.cell_rows(); ++j) {
    for (std::int32_t i = 0; i < grid.cell_columns(); ++i) {
      mesh.triangles.push_back({number(j, i), number(j, i + 1), number(j + 1, i + 1)});
      mesh.triangles.push_back({number(j, i), number(j + 1, i + 1), number(j + 1, i)});
      const std::int32_t piece =
          smooth.piece_of[static_cast<std::size_t>(j * grid.cell_columns() + i)];
      known.of.insert(known.of.end(), 2, piece);
    }
  }
  for (const bool top : {false, true}) {
    const std::int32_t row = top ? grid.rows - 1 : 0;
    Vec3 middle(0);
    for (std::int32_t i = 0; i < grid.columns; ++i) middle += grid.point(row, i);
    const auto center = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.push_back(middle / static_cast<double>(grid.columns));
    for (std::int32_t i = 0; i < grid.columns; ++i) {
      const std::uint32_t a = number(row, i), b = number(row, i + 1);
      mesh.triangles.push_back(top ? Triangle{a, b, center} : Triangle{b, a, center});
      known.of.push_back(KnownSurfaces::kMeantFlat);
    }
  }
  return {mesh, known, RunContext()};
}

std::size_t told_cells(const SmoothGrids& g) {
  return static_cast<std::size_t>(
      std::count_if(g.piece_of.begin(), g.piece_of.end(), [](std::int32_t p) { return p >= 0; }));
}

/// A bar of a square or a round section along a circle, twisted; its last ring is the first again.
PointGrid ring_bar(std::int32_t corners, double twist, bool columns_again) {
  constexpr std::int32_t kRings = 61;
  PointGrid out;
  out.rows = kRings;
  out.columns = corners + (columns_again ? 1 : 0);
  out.columns_close = !columns_again;
  for (std::int32_t j = 0; j < kRings; ++j) {
    const double a = 2 * kPi * j / (kRings - 1);
    for (std::int32_t i = 0; i < out.columns; ++i) {
      const double b = 2 * kPi * i / corners + twist * j / (kRings - 1), r = 20 + 4 * std::cos(b);
      out.points.emplace_back(r * std::cos(a), r * std::sin(a), 4 * std::sin(b));
    }
  }
  return out;
}

TEST(SmoothGrids, CloseWhereTheLastRowIsTheFirst) {
  const SmoothGrids s = smooth_grids(ring_bar(4, 2 * kPi, false), Rows::Judged);
  EXPECT_EQ(told_cells(s), 240u);
  ASSERT_EQ(s.pieces.size(), 4u);
  for (const PointGrid& p : s.pieces) {
    EXPECT_TRUE(p.rows_close);
    EXPECT_EQ(p.rows, 60);
  }
  // Columns likewise; neither is told in parts, as nothing meets itself in an edge.
  const SmoothGrids round = smooth_grids(ring_bar(24, 2 * kPi, true), Rows::Judged);
  EXPECT_EQ(told_cells(round), 60u * 24u);
  ASSERT_EQ(round.pieces.size(), 1u);
  EXPECT_TRUE(round.pieces[0].rows_close && round.pieces[0].columns_close);
  EXPECT_EQ(round.pieces[0].columns, 24);
  // A ring that comes back turned by some of its corners: two parts meet there.
  const SmoothGrids turned = smooth_grids(ring_bar(24, kPi / 2, false), Rows::Judged);
  ASSERT_EQ(turned.pieces.size(), 2u);
  EXPECT_FALSE(turned.pieces[0].rows_close);
  EXPECT_FALSE(turned.pieces[0].window.overlaps(turned.pieces[1].window));
}

TEST(SmoothGrids, PartAtCornersAlone) {
  const SmoothGrids s = smooth_grids(extruded(star(10, 20, 9), 21, 40 * kPi / 180), Rows::Steps);
  EXPECT_EQ(s.pieces.size(), 10u);
  EXPECT_EQ(told_cells(s), 200u);
  for (const PointGrid& p : s.pieces) {
    EXPECT_EQ(p.columns, 2);
    EXPECT_EQ(p.rows, 21);
  }
  // By its angles alone, as in a polyhedron, it is the same.
  EXPECT_EQ(smooth_grids(extruded(star(10, 20, 9), 21, 40 * kPi / 180), Rows::Judged).pieces.size(),
            10u);
}

TEST(SmoothGrids, AnEllipseIsOneClosedPiece) {
  const SmoothGrids s = smooth_grids(extruded(ellipse(48, 10, 6)), Rows::Steps);
  ASSERT_EQ(s.pieces.size(), 1u);
  EXPECT_TRUE(s.pieces[0].columns_close);
  EXPECT_EQ(told_cells(s), 48u);
}

TEST(SmoothGrids, OutlinesOfFewSidesThatBendUnevenlyAreSmooth) {
  for (const auto& [corners, width] :
       {std::pair{16, 12.0}, {12, 12.0}, {20, 15.0}, {30, 20.0}, {24, 20.0}}) {
    EXPECT_EQ(smooth_grids(extruded(ellipse(corners, width, 10)), Rows::Steps).pieces.size(), 1u)
        << corners << ' ' << width;
  }
  // Lobes: turns go through zero.
  for (const auto& [lobes, corners] : {std::pair{5, 60}, {8, 160}}) {
    std::vector<Vec2> wave;
    for (int i = 0; i < corners; ++i) {
      const double a = 2 * kPi * i / corners, r = 12 * (1 + 0.15 * std::cos(lobes * a));
      wave.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    EXPECT_EQ(smooth_grids(extruded(wave), Rows::Steps).pieces.size(), 1u) << lobes;
  }
  // A kink between walls stays one, however small.
  const SmoothGrids kink = smooth_grids(
      extruded({{0, 0}, {10, 0}, {20, 1.4}, {30, 4.2}, {30, 20}, {0, 20}}), Rows::Steps);
  EXPECT_TRUE(kink.pieces.empty());
}

TEST(SmoothGrids, ASpringIsOnePieceHoweverItIsTurned) {
  for (const double turn : {0.0, 0.3, 1.1}) {
    const PointGrid spring = grid_of(21, 12, true, [&](int j, int i) {
      const double a = 18 * kPi / 180 * j + turn, b = kPi / 6 * i, r = 10 + 2 * std::cos(b);
      return Vec3(r * std::cos(a), r * std::sin(a), 2 * std::sin(b) + 0.3 * j);
    });
    EXPECT_EQ(smooth_grids(spring, Rows::Judged).pieces.size(), 1u) << turn;
  }
}

TEST(SmoothGrids, PlanesCirclesAndWhatIsTurnedAreLeftToOthers) {
  EXPECT_TRUE(smooth_grids(extruded(star(6, 10, 10)), Rows::Steps).pieces.empty());
  EXPECT_TRUE(smooth_grids(extruded(ellipse(48, 10, 10)), Rows::Steps).pieces.empty());
  // A slot: half circles and walls.
  std::vector<Vec2> slot;
  for (const double side : {1.0, -1.0}) {
    for (int i = 0; i <= 12; ++i) {
      const double a = kPi * (i / 12.0 - 0.5);
      slot.push_back(side * Vec2(15 + 5 * std::cos(a), 5 * std::sin(a)));
    }
  }
  EXPECT_TRUE(smooth_grids(extruded(slot), Rows::Steps).pieces.empty());
  const PointGrid vase = grid_of(12, 24, true, [](int j, int i) {
    const double a = 2 * kPi * i / 24, r = 10 + 3 * std::sin(0.4 * j);
    return Vec3(r * std::cos(a), r * std::sin(a), 2 * j);
  });
  EXPECT_TRUE(smooth_grids(vase, Rows::Judged).pieces.empty());
}

TEST(SmoothGrids, AnOutlineWithOneCornerIsToldAsTwoParts) {
  std::vector<Vec2> drop;  // a loop that begins and ends in a tip
  for (int i = 0; i < 60; ++i) {
    const double t = i / 60.0, s = 1 - t;
    drop.push_back((s * s * s + t * t * t) * Vec2(11, 0) + 3 * s * s * t * Vec2(0, 18) +
                   3 * s * t * t * Vec2(0, -18));
  }
  const SmoothGrids s = smooth_grids(extruded(drop), Rows::Steps);
  ASSERT_EQ(s.pieces.size(), 2u);
  EXPECT_EQ(s.pieces[0].points, s.pieces[1].points);
  EXPECT_EQ(s.pieces[0].window.columns + s.pieces[1].window.columns, s.pieces[0].cell_columns());
  // The edge at the tip is there, and no other.
  const RecognisedForm form = form_of(extruded(drop));
  EXPECT_EQ(form.faces().swept, 1);
  RunContext context;
  const auto surface = form.realise({.tolerance = 0.01}, context);
  const ProxyMesh& proxy = surface->proxy();
  double upright = 0;
  for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
    const Vec3 a = proxy.mesh.positions[origin(proxy.mesh, static_cast<HalfEdge>(h))],
               b = proxy.mesh.positions[origin(proxy.mesh, next_in_face(static_cast<HalfEdge>(h)))];
    if (proxy.edge_kind[h] == EdgeKind::Smooth || std::abs(a.z - b.z) < 1e-6) continue;
    EXPECT_NEAR(a.x, 11, 1e-6);
    upright += 0.5 * std::abs(a.z - b.z);
  }
  EXPECT_NEAR(upright, 10, 1e-6);
}

TEST(SmoothGrids, AnEllipticWallLiesOnTheEllipse) {
  const RecognisedForm form = form_of(extruded(ellipse(48, 10, 6)));
  EXPECT_EQ(form.faces().swept, 1);
  EXPECT_EQ(form.faces().total(), 1);
  RunContext context;
  const auto surface = form.realise({.tolerance = 0.001}, context);
  std::size_t on_wall = 0;
  for (const Vec3& p : surface->proxy().mesh.positions) {
    if (std::hypot(p.x, p.y) < 1) continue;
    ++on_wall;
    // Its chords lie twenty times as far inside.
    EXPECT_NEAR(std::hypot(p.x / 10, p.y / 6), 1, 1e-4);
  }
  EXPECT_GT(on_wall, 300u);
}

TEST(SmoothGrids, ATwistedWallIsTheHelicoid) {
  const double twist = 40 * kPi / 180;
  const RecognisedForm form = form_of(extruded(star(10, 20, 9), 21, twist));
  EXPECT_EQ(form.faces().swept, 10);
  RunContext context;
  const auto surface = form.realise({.tolerance = 0.001}, context);
  const Vec2 a(20, 0), b = 9.0 * Vec2(std::cos(kPi / 5), std::sin(kPi / 5));
  const Vec2 along = glm::normalize(b - a);
  std::size_t on_wall = 0;
  for (const Vec3& p : surface->proxy().mesh.positions) {
    const double t = -twist * p.z / 10;
    const Vec2 q(std::cos(t) * p.x - std::sin(t) * p.y, std::sin(t) * p.x + std::cos(t) * p.y);
    const double at = glm::dot(q - a, along);
    if (at < 0.5 || at > glm::distance(a, b) - 0.5 || q.x < 0 || q.y < 0) continue;
    const double off = std::abs(along.x * (q - a).y - along.y * (q - a).x);
    if (off > 0.5 || p.z < 0.1 || p.z > 9.9) continue;
    ++on_wall;
    EXPECT_LT(off, 1e-4);
  }
  EXPECT_GT(on_wall, 20u);
}

}  // namespace
}  // namespace burin
