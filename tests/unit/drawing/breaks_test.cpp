// Bands that are left out of a drawing.
#include <burin/drawing/break_up.h>
#include <burin/drawing/clip.h>
#include <burin/drawing/length.h>
#include <burin/planar/even_odd.h>

#include "burin_test/drawings.h"
#include "burin_test/ring_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace burin {
namespace {

using test::plain_path;

PaperBreaks two_bands() {
  return {.along = {1, 0}, .bands = {{10, 30}, {50, 53}}, .gap = 4, .offset = {1, 2}};
}

/// By the even-odd rule.
bool inside(const std::vector<std::vector<Vec2>>& rings, Vec2 p) {
  bool in = false;
  for (const std::vector<Vec2>& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (crosses_ray(ring[i], ring[(i + 1) % ring.size()], p)) in = !in;
    }
  }
  return in;
}

Drawing drawing_of(std::vector<Path> paths) {
  Drawing drawing;
  drawing.layers.push_back({"crease", std::move(paths)});
  return drawing;
}

TEST(PaperBreaks, MovesEachPieceAsAWhole) {
  const PaperBreaks breaks = two_bands();
  EXPECT_EQ(breaks.moved({0, 7}), Vec2(1, 9));
  EXPECT_EQ(breaks.moved({10, 7}), Vec2(11, 9));
  EXPECT_EQ(breaks.moved({30, 7}), Vec2(15, 9));  // a gap of 4 behind 11
  EXPECT_EQ(breaks.moved({50, 0}), Vec2(35, 2));
  EXPECT_EQ(breaks.moved({53, 0}), Vec2(38, 2));  // narrower than the gap: all of it is left
  EXPECT_EQ(breaks.moved({63, 0}), Vec2(48, 2));
  EXPECT_LT(glm::distance(breaks.moved({20, 0}), Vec2(13, 2)), 1e-12);
  EXPECT_TRUE(breaks.leaves_out({20, 99}));
  EXPECT_FALSE(breaks.leaves_out({10, 0}) || breaks.leaves_out({30, 0}));
  EXPECT_EQ(PaperBreaks().moved({3, 4}), Vec2(3, 4));
  const PaperBreaks farther = breaks.of_moved_view({5, 6});
  for (const double x : {0.0, 12.0, 40.0, 70.0}) {
    EXPECT_LT(glm::distance(farther.moved({x + 5, 6}), breaks.moved({x, 0})), 1e-12) << x;
  }
}

TEST(BreakUp, CutsLinesAndMovesWhatIsLeft) {
  Drawing drawing = drawing_of({plain_path({{0, 5}, {60, 5}}), plain_path({{12, 0}, {28, 9}}),
                                plain_path({{40, 0}, {42, 0}, {42, 3}}, true)});
  break_up({.along = {1, 0}, .bands = {{10, 30}}, .gap = 4}, {}, drawing);
  const std::vector<Path>& paths = drawing.layers[0].paths;
  ASSERT_EQ(paths.size(), 3U);  // the second one is gone
  EXPECT_EQ(paths[0].points, (std::vector<Vec2>{{0, 5}, {10, 5}}));
  EXPECT_EQ(paths[1].points, (std::vector<Vec2>{{14, 5}, {44, 5}}));
  EXPECT_EQ(paths[1].points3.front(), Vec3(60, 10, 1)) << "where it is in the model";
  EXPECT_EQ(paths[1].source, (SourceId{2, 5, 7}));
  EXPECT_TRUE(paths[2].closed) << "whole on one side";
  EXPECT_EQ(paths[2].points.front(), Vec2(24, 0));
}

TEST(BreakUp, LetsCentreLinesThroughThatShareTheWay) {
  Path axis = plain_path({{-2, 5}, {62, 5}}), of_hole = plain_path({{20, 0}, {20, 10}}),
       ends_within = plain_path({{0, 8}, {20, 8}}), frame = plain_path({{15, 1}, {16, 1}});
  axis.kind = of_hole.kind = ends_within.kind = LineClass::Centre;
  frame.kind = LineClass::Frame;
  Drawing drawing = drawing_of({axis, of_hole, ends_within, frame});
  break_up({.along = {1, 0}, .bands = {{10, 30}}, .gap = 4}, {}, drawing);
  const std::vector<Path>& paths = drawing.layers[0].paths;
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_EQ(paths[0].points, (std::vector<Vec2>{{-2, 5}, {46, 5}}));
  EXPECT_EQ(paths[1].points, (std::vector<Vec2>{{0, 8}, {10, 8}}));
  EXPECT_EQ(paths[2].points, frame.points) << "what lies over a drawing stays";
}

TEST(BreakUp, CutsAreas) {
  std::vector<Area> areas(2);
  areas[0].rings = {{{0, 0}, {60, 0}, {60, 10}, {0, 10}}, {{12, 2}, {20, 2}, {20, 4}}};
  areas[1].rings = {{{12, 2}, {20, 2}, {20, 4}}};
  break_up({.along = {1, 0}, .bands = {{10, 30}}, .gap = 4}, {}, areas);
  ASSERT_EQ(areas.size(), 1U) << "one lay in the band";
  ASSERT_EQ(areas[0].rings.size(), 2U);
  EXPECT_NEAR(std::abs(test::signed_area(areas[0].rings[0])), 100, 1e-9);
  EXPECT_NEAR(std::abs(test::signed_area(areas[0].rings[1])), 300, 1e-9);
  for (const Vec2& p : areas[0].rings[1]) EXPECT_GE(p.x, 14 - 1e-12);
}

TEST(BreakUp, JoinsNoPiecesOfAnAreaAlongTheCut) {
  // A ladder lying on its side with a hole in a rail: two rails are left, nothing between them.
  std::vector<Area> areas(1);
  areas[0].rings = {{{0, 0}, {60, 0}, {60, 20}, {0, 20}},
                    {{5, 5}, {5, 15}, {55, 15}, {55, 5}},
                    {{8, 1}, {52, 1}, {52, 3}, {8, 3}}};
  break_up({.along = {1, 0}, .bands = {{10, 30}, {35, 50}}, .gap = 4}, {}, areas);
  double size = 0;
  int rings = 0;
  for (const std::vector<Vec2>& ring : areas[0].rings) {
    ++rings;
    size += std::abs(test::signed_area(ring));
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
      // No side runs along a cut where the area has nothing.
      const bool along_cut = a.x == b.x && (a.x == 10 || a.x == 14 || a.x == 19 || a.x == 23);
      if (!along_cut) continue;
      EXPECT_LE(std::abs(a.y - b.y), 5) << a.x << ": " << a.y << " to " << b.y;
    }
  }
  // At both ends a fork; of each piece between three bars.
  EXPECT_EQ(rings, 1 + 3 + 1);
  EXPECT_NEAR(size, (10 * 20 - 5 * 10 - 2 * 2) * 2 + 5 * (5 + 5 - 2), 1e-9);
}

/// A jagged edge: lines and areas end on it, whichever way they come.
TEST(BreakUp, EndsAtAJaggedEdge) {
  const std::vector<Vec2> edge{{2, 0}, {4, 1.5}, {6, -1.5}, {8, 0}};
  const PaperBreaks breaks{.along = {1, 0}, .bands = {{20, 50}}, .gap = 5};
  std::vector<Path> lines;
  for (double y = 0; y <= 10; y += 0.25) lines.push_back(plain_path({{0, y}, {70, y}}));
  lines.push_back(plain_path({{0, 0}, {70, 10}}));
  Drawing drawing = drawing_of(lines);
  std::vector<Area> areas(1);
  areas[0].rings = {{{0, 0}, {70, 0}, {70, 10}, {0, 10}}};
  break_up(breaks, edge, drawing);
  break_up(breaks, edge, areas);
  ASSERT_EQ(drawing.layers[0].paths.size(), 2 * lines.size());
  int ends = 0;
  for (const Path& path : drawing.layers[0].paths) {
    for (const Vec2& p : {path.points.front(), path.points.back()}) {
      if (p.x < 1 || p.x > 44) continue;
      const double side = p.x - edge_at(edge, p.y);
      EXPECT_LT(std::min(std::abs(side - 20), std::abs(side - 25)), 1e-9) << p.x << " " << p.y;
      ++ends;
    }
    for (std::size_t i = 1; i < path.points3.size(); ++i) {
      EXPECT_GE(path.points[i].x, path.points[i - 1].x - 1e-12);
    }
  }
  EXPECT_EQ(ends, static_cast<int>(2 * lines.size()));
  ASSERT_EQ(areas[0].rings.size(), 2U);
  // What the edge adds at one place it takes at another.
  EXPECT_NEAR(std::abs(test::signed_area(areas[0].rings[0])), 200, 1e-9);
  EXPECT_NEAR(std::abs(test::signed_area(areas[0].rings[1])), 200, 1e-9);
  int corners = 0;
  for (const Vec2& p : areas[0].rings[0]) {
    corners += glm::distance(p, Vec2(21.5, 4)) < 1e-9 || glm::distance(p, Vec2(18.5, 6)) < 1e-9;
  }
  EXPECT_EQ(corners, 2);
}

/// Any rings, as the even-odd rule has them: what is inside of the whole area is inside of what is
/// left of it.
TEST(BreakUp, KeepsWhatIsInside) {
  std::mt19937 random(7);
  const auto number = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  const std::vector<Vec2> edge{{2, 0}, {4, 1.5}, {6, -1.5}, {8, 0}};
  for (int round = 0; round < 40; ++round) {
    const double turn = round % 2 == 0 ? 0 : number(0, 6);
    const PaperBreaks breaks{
        .along = {std::cos(turn), std::sin(turn)}, .bands = {{-20, -5}, {3, 12}}, .gap = 4};
    const Strip sides{0, 0, breaks.along, edge};
    std::vector<Area> areas(1);
    for (int ring = 0; ring < 3; ++ring) {
      for (int i = 0; i < 7; ++i) {
        if (i == 0) areas[0].rings.emplace_back();
        areas[0].rings.back().emplace_back(number(-40, 40), number(-40, 40));
      }
    }
    const std::vector<std::vector<Vec2>> whole = areas[0].rings;
    break_up(breaks, edge, areas);
    ASSERT_EQ(areas.size(), 1U);
    for (int i = 0; i < 500; ++i) {
      const Vec2 p(number(-40, 40), number(-40, 40));
      const double at = sides.at(p);
      std::size_t piece = 0;
      bool within = false;
      for (const PaperBreaks::Band& band : breaks.bands) {
        within = within || (at > band.low && at < band.high);
        piece += at >= band.high ? 1 : 0;
      }
      if (within) continue;
      EXPECT_EQ(inside(areas[0].rings, p + breaks.shift(piece)), inside(whole, p))
          << round << ": " << p.x << " " << p.y;
    }
  }
}

TEST(BreakUp, WorksAlongAnyDirection) {
  const Vec2 along = glm::normalize(Vec2(2, 1));
  const PaperBreaks breaks{.along = along, .bands = {{10, 30}}, .gap = 4};
  Drawing drawing = drawing_of({plain_path({Vec2(0), 60.0 * along})});
  break_up(breaks, {}, drawing);
  ASSERT_EQ(drawing.layers[0].paths.size(), 2U);
  double length = 0;
  for (const Path& path : drawing.layers[0].paths) length += length_of(path);
  EXPECT_NEAR(length, 40, 1e-9);
  EXPECT_LT(glm::distance(drawing.layers[0].paths[1].points.back(), 44.0 * along), 1e-9);
}

}  // namespace
}  // namespace burin
