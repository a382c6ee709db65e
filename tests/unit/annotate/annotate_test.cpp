#include <burin/annotate/annotate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

double leader_angle(double hatched_at) {
  RunContext context;
  Drawing drawing = hatched_square(hatched_at);
  const LabelMap seen = make_label_map(
      {{100, 60}, {196, 150}},
      [](Vec2 p) {
        const Vec2 off = glm::abs(p - Vec2(148, 105));
        return off.x < 40 && off.y < 40 ? 0 : -1;
      },
      context);
  Annotations over;
  over.items = {{1, "plate", {0}, "", ""}};
  over.callouts = true;
  over.margin = Margin(10);
  annotate(drawing, seen, {}, over, {}, context);
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

}  // namespace
}  // namespace burin
