// Lines of a sheet whose phase has dislocations that nothing asks for.
#include "wave_pairs.h"

#include <burin/base/error.h>
#include <burin/base/rng.h>

#include "border_lines.h"
#include "level_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace burin {
namespace {

using namespace detail;

constexpr double kPi = std::numbers::pi;
constexpr std::int32_t kNx = 60, kNy = 40;
constexpr double kPairGap = 1.1;  // mm between upright lines

struct Sheet {
  Sheet() {
    raster.nx = kNx;
    raster.ny = kNy;
    raster.cells.resize(static_cast<std::size_t>(kNx) * kNy);
    for (RasterCell& c : raster.cells) c.facing = 1;
    const std::size_t n = raster.cells.size();
    graph.node.resize(n);
    graph.right.assign(n, kNone);
    graph.up.assign(n, kNone);
    graph.diagonal.assign(n, kNone);
    graph.parent_link.assign(n, kNone);
    graph.component.assign(n, 0);
    graph.components = 1;
    for (std::size_t i = 0; i < n; ++i) {
      graph.node[i] = static_cast<std::int32_t>(i);
      graph.nodes.push_back({static_cast<std::uint32_t>(i), Vec2(1 / kPairGap, 0), true});
      graph.order.push_back(static_cast<std::uint32_t>(i));
    }
    for (std::int32_t y = 0; y < kNy; ++y) {
      for (std::int32_t x = 0; x < kNx; ++x) {
        if (x + 1 < kNx) graph.right[cell(x, y)] = link(x, y, 1, 0, 1);
        if (y + 1 < kNy) graph.up[cell(x, y)] = link(x, y, 0, 1, 1);
        if (x + 1 < kNx && y + 1 < kNy) graph.diagonal[cell(x, y)] = link(x, y, 1, 1, 0.25);
      }
    }
  }

  static std::size_t cell(std::int32_t x, std::int32_t y) {
    return static_cast<std::size_t>(y) * kNx + static_cast<std::size_t>(x);
  }
  std::int32_t link(std::int32_t x, std::int32_t y, int dx, int dy, double weight) {
    graph.links.push_back({static_cast<std::uint32_t>(cell(x, y)),
                           static_cast<std::uint32_t>(cell(x + dx, y + dy)),
                           raster.pitch * Vec2(dx, dy), weight, false});
    return static_cast<std::int32_t>(graph.links.size()) - 1;
  }

  // Even lines and what winds around these places, one way or the other.
  WavePhase winding(const std::vector<std::pair<Vec2, int>>& places) const {
    WavePhase phase;
    for (std::int32_t y = 0; y < kNy; ++y) {
      for (std::int32_t x = 0; x < kNx; ++x) {
        const Vec2 p = raster.center(x, y);
        double turn = 2 * kPi * p.x / kPairGap + 0.3;
        for (const auto& [at, way] : places) turn += way * std::atan2(p.y - at.y, p.x - at.x);
        phase.at.push_back(turn - 2 * kPi * std::floor(turn / (2 * kPi)));
      }
    }
    for (const WaveLink& l : graph.links) {
      const double turn = turn_along(graph, l);
      phase.advance.push_back(turn + std::remainder(phase.at[l.b] - phase.at[l.a] - turn, 2 * kPi));
    }
    return phase;
  }

  int ends_inside(const WavePhase& phase) const {
    int count = 0;
    for (const LevelLine& line : level_lines(raster, graph, phase, context)) {
      count += static_cast<int>(line.begin_inside) + static_cast<int>(line.end_inside);
    }
    return count;
  }
  // Of a link's advance, off what its wave asks for, in turns.
  double worst(const WavePhase& phase) const {
    double most = 0;
    for (std::size_t k = 0; k < graph.links.size(); ++k) {
      most = std::max(most, std::abs(phase.advance[k] - turn_along(graph, graph.links[k])));
    }
    return most / (2 * kPi);
  }

  ViewRaster raster;
  WaveGraph graph;
  RunContext context;
};

TEST(WavePairs, OppositeDislocationsCancel) {
  const Sheet sheet;
  WavePhase phase = sheet.winding({{{10.1, 8.1}, 1}, {{13.1, 9.3}, -1}});
  EXPECT_GT(sheet.ends_inside(phase), 0);
  cancel_pairs(sheet.raster, sheet.graph, {}, phase, sheet.context);
  EXPECT_EQ(sheet.ends_inside(phase), 0);
  EXPECT_LT(sheet.worst(phase), 0.01);
  // 24 mm of sheet: a line each 1.1 mm, all from border to border.
  const auto lines = level_lines(sheet.raster, sheet.graph, phase, sheet.context);
  EXPECT_NEAR(static_cast<double>(lines.size()), 24 / kPairGap, 1.5);
}

TEST(WavePairs, OneThatNothingCancelsStays) {
  const Sheet sheet;
  WavePhase phase = sheet.winding({{{12.1, 8.1}, 1}});
  const int before = sheet.ends_inside(phase);
  EXPECT_GT(before, 0);
  cancel_pairs(sheet.raster, sheet.graph, {}, phase, sheet.context);
  EXPECT_EQ(sheet.ends_inside(phase), before);
}

TEST(WavePairs, OneRightBesideABorderLeavesByIt) {
  const Sheet sheet;
  WavePhase phase = sheet.winding({{{12.1, 0.5}, 1}});
  EXPECT_GT(sheet.ends_inside(phase), 0);
  cancel_pairs(sheet.raster, sheet.graph, {}, phase, sheet.context);
  EXPECT_EQ(sheet.ends_inside(phase), 0);
}

// Of three lines that reach the place two are one: it never has three tips beside each other.
TEST(LevelLines, OneEndsWhereThePhaseWindsOnce) {
  const Sheet sheet;
  const Rng rng(5);
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Vec2 at(8 + 8 * rng.uniform(2 * i), 5 + 6 * rng.uniform(2 * i + 1));
    const WavePhase phase = sheet.winding({{at, i % 2 == 0 ? 1 : -1}});
    EXPECT_EQ(sheet.ends_inside(phase), 1) << at.x << ", " << at.y;
  }
}

// A piece of a ring of 12 mm about a place in the middle of the sheet, from one angle to another.
LevelLine ring_piece(const Vec2& middle, double from, double to, std::int64_t number) {
  constexpr double kRadius = 12;
  constexpr int kSteps = 40;
  LevelLine line;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = from + (to - from) * i / kSteps;
    line.points.push_back(middle + kRadius * Vec2(std::cos(a), std::sin(a)));
    line.gaps.push_back(static_cast<float>(kPairGap));
  }
  line.number = number;
  return line;
}

// A ring that touches the border leaves the cells and comes back: 4.8 mm on, 23 degrees round.
TEST(BorderLines, PiecesOfARingGoOnIntoOneAnother) {
  const Sheet sheet;
  const Vec2 middle(12, 8);
  std::vector<LevelLine> lines{ring_piece(middle, 0.4, 1.3, 7), ring_piece(middle, 1.7, 2.6, 7)};
  join_along_borders(sheet.raster, sheet.graph, lines, sheet.context);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_GT(lines[0].points.size(), 2 * 41U);
  for (const Vec2& p : lines[0].points) EXPECT_NEAR(glm::distance(p, middle), 12, 0.1);
}

TEST(BorderLines, OthersStayApart) {
  const Sheet sheet;
  const Vec2 middle(12, 8);
  const auto count = [&](LevelLine a, LevelLine b) {
    std::vector<LevelLine> lines{std::move(a), std::move(b)};
    join_along_borders(sheet.raster, sheet.graph, lines, sheet.context);
    return lines.size();
  };
  const LevelLine first = ring_piece(middle, 0.4, 1.3, 7);
  EXPECT_EQ(count(first, ring_piece(middle, 1.7, 2.6, 8)), 2U);  // of another number
  // One that bends the other way, and one beside the first.
  LevelLine back = ring_piece(middle, 1.7, 2.6, 7);
  for (Vec2& p : back.points) p.y = 2 * back.points.front().y - p.y;
  EXPECT_EQ(count(first, back), 2U);
  EXPECT_EQ(count(first, ring_piece(middle + Vec2(0, 4), 1.7, 2.6, 7)), 2U);
}

TEST(WavePairs, HearsACancel) {
  Sheet sheet;
  WavePhase phase = sheet.winding({{{10.1, 8.1}, 1}, {{13.1, 9.3}, -1}});
  sheet.context.cancel();
  EXPECT_THROW(cancel_pairs(sheet.raster, sheet.graph, {}, phase, sheet.context), Cancelled);
}

}  // namespace
}  // namespace burin
