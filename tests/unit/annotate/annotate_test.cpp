#include <burin/annotate/annotate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// A square of 80 mm in the middle of A4, hatched at an angle.
Drawing hatched_square(double degrees) {
  Drawing drawing;
  Path outline;
  outline.kind = LineClass::Contour;
  outline.source.part = 0;
  outline.points = {{108, 65}, {188, 65}, {188, 145}, {108, 145}};
  outline.closed = true;
  outline.width = {0.3};
  Layer lines{"contour", {outline}}, strokes{"stroke", {}};
  const double a = degrees * std::numbers::pi / 180;
  const Vec2 along(std::cos(a), std::sin(a)), across(-along.y, along.x), middle(148, 105);
  for (int i = -40; i <= 40; ++i) {
    Path stroke;
    stroke.kind = LineClass::Stroke;
    stroke.source.part = 0;
    stroke.width = {0.2};
    for (int k = -40; k <= 40; ++k) {
      const Vec2 p = middle + static_cast<double>(k) * along + static_cast<double>(i) * across;
      const Vec2 off = glm::abs(p - middle);
      if (off.x < 40 && off.y < 40) stroke.points.push_back(p);
    }
    if (stroke.points.size() > 1) strokes.paths.push_back(stroke);
  }
  drawing.layers = {strokes, lines};
  return drawing;
}

/// Gives items their callouts.
void number(Drawing& drawing, std::span<const Area> seen, std::vector<DrawingItem> items) {
  Annotations over;
  over.items = std::move(items);
  over.callouts = true;
  over.margin = Margin(10);
  RunContext context;
  annotate(drawing, seen, over, {}, context);
}

double leader_angle(double hatched_at) {
  Drawing drawing = hatched_square(hatched_at);
  const Area seen{.part = 0, .rings = {drawing.layers[1].paths[0].points}};
  number(drawing, {&seen, 1}, {{1, "plate", {0}, "", ""}});
  for (const Path& path : drawing.layers.back().paths) {
    if (path.kind != LineClass::Leader || path.points.size() != 2) continue;
    const Vec2 way = path.points[1] - path.points[0];
    if (glm::length(way) < 5) continue;
    return std::atan2(way.y, way.x) * 180 / std::numbers::pi;
  }
  ADD_FAILURE() << "no leader";
  return 0;
}

TEST(Annotate, LeadersCrossHatchingInsteadOfRunningAlongIt) {
  const auto off = [](double a, double b) { return std::abs(std::remainder(a - b, 180.0)); };
  // Across the strokes the shortest way is level.
  EXPECT_LT(off(leader_angle(90), 0), 3);
  for (const double degrees : {0.0, 5.0, -8.0}) EXPECT_GT(off(leader_angle(degrees), degrees), 12);
}

std::vector<Vec2> rectangle(Vec2 a, Vec2 b) { return {a, {b.x, a.y}, b, {a.x, b.y}}; }

Path line(std::int32_t part, std::vector<Vec2> points) {
  Path path;
  path.kind = LineClass::Crease;
  path.source.part = part;
  path.width = {0.3};
  path.points = std::move(points);
  return path;
}

/// The leaders of a drawing: where they begin, and whether with a dot.
std::vector<std::pair<Vec2, bool>> begins(const Drawing& drawing) {
  std::vector<std::pair<Vec2, bool>> out;
  for (const Path& path : drawing.layers.back().paths) {
    if (path.kind != LineClass::Leader || path.points.size() != 2) continue;
    const bool dot = path.points[0] == path.points[1], arrow = path.width.size() == 2;
    if (dot || arrow) out.push_back({path.points[1], dot});
  }
  return out;
}

TEST(Annotate, LeadersBeginInTheLargestDiscWithoutALineAndAtTheLineOfWhatIsNarrow) {
  // A plate of 60 by 40 mm with a line 20 mm from its left; a bar of 1 mm with a line along it; and
  // a part that is not seen.
  const std::vector<Area> seen{{.part = 0, .rings = {rectangle({100, 60}, {160, 100})}},
                               {.part = 1, .rings = {rectangle({100, 120}, {160, 121})}}};
  Drawing drawing;
  drawing.layers = {
      {"crease", {line(0, {{120, 60}, {120, 100}}), line(1, {{110, 121}, {150, 121}})}}};
  number(drawing, seen,
         {{1, "plate", {0}, "", ""}, {2, "bar", {1}, "", ""}, {3, "pin", {2}, "", ""}});
  const auto at = begins(drawing);
  ASSERT_EQ(at.size(), 2U);
  EXPECT_TRUE(at[0].second);
  EXPECT_NEAR(glm::distance(at[0].first, Vec2(140, 80)), 0, 0.2);
  EXPECT_FALSE(at[1].second) << "an arrow";
  EXPECT_NEAR(glm::distance(at[1].first, Vec2(130, 121)), 0, 1e-9);
  ASSERT_EQ(drawing.diagnostics.entries().size(), 1U);
  EXPECT_EQ(drawing.diagnostics.entries()[0].code, "callouts.not_shown");
}

TEST(Annotate, GlassHasItsDotWhereItAloneIsSeen) {
  // A pane; behind its middle a plate. Then a pane that the plate fills: their dots part.
  for (const double margin : {12.0, 0.0}) {
    const Vec2 low(100, 60), high(160, 100);
    const std::vector<Area> seen{{.part = 1, .rings = {rectangle(low, high)}},
                                 {.part = 0, .rings = {rectangle(low + margin, high - margin)}}};
    Drawing drawing;
    drawing.layers = {{"outline", {line(1, seen[0].rings[0]), line(0, seen[1].rings[0])}}};
    for (Path& path : drawing.layers[0].paths) path.closed = true;
    number(drawing, seen, {{1, "plate", {0}, "", ""}, {2, "pane", {1}, "", ""}});
    const auto at = begins(drawing);
    ASSERT_EQ(at.size(), 2U);
    EXPECT_GT(glm::distance(at[0].first, at[1].first), 2);
    const Vec2 pane = at[1].first;
    EXPECT_TRUE(pane.x > low.x && pane.x < high.x && pane.y > low.y && pane.y < high.y);
    const Box2 plate{low + margin, high - margin};
    EXPECT_EQ(plate.contains(pane), margin == 0);
  }
}

TEST(Annotate, OfPartsThatAreSeenAlikeTheFirstOfTheOutermostCounts) {
  std::vector<Area> seen;
  for (int i = 0; i < 3; ++i) {
    const Vec2 at(60 + 60 * i, 80);
    seen.push_back({.part = i, .rings = {rectangle(at, at + Vec2(20.0 + 0.01 * i, 20.0))}});
  }
  Drawing drawing;
  drawing.layers = {{"outline", {}}};
  for (const Area& area : seen) drawing.layers[0].paths.push_back(line(area.part, area.rings[0]));
  number(drawing, seen, {{1, "post", {0, 1, 2}, "", ""}});
  const auto at = begins(drawing);
  ASSERT_EQ(at.size(), 1U);
  EXPECT_LT(at[0].first.x, 80);
}

}  // namespace
}  // namespace burin
