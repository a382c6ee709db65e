// Where a line ends inside the surface, and how wide lines are that draw together.
#include <burin/stroke/stroke.h>

#include "burin_test/shapes.h"
#include "burin_test/stroke_stage.h"
#include "sample_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace burin {
namespace {

using Stage = test::StrokeStage;
using namespace detail;

constexpr double kGap = 0.8;  // mm
const HatchOptions kTipFamily{.spacing_min = kGap,
                              .spacing_max = 2 * kGap,
                              .width_min = 0.1,
                              .width_max = 0.5,
                              .tone_min = 0.05,
                              .cross_from = 2,
                              .length_max = 300};

// The x on both sides of a place at which strokes pass its height.
struct Passing {
  double left = -1e9, right = 1e9;
};
Passing passing(const StrokeResult& r, const Curve3* but, Vec3 at) {
  Passing out;
  for (const Curve3& c : r.strokes) {
    for (std::size_t i = 1; &c != but && i < c.points.size(); ++i) {
      const Vec3 a = c.points[i - 1], b = c.points[i];
      if ((a.z < at.z) == (b.z < at.z)) continue;
      const double x = a.x + (at.z - a.z) / (b.z - a.z) * (b.x - a.x);
      (x < at.x ? out.left : out.right) = x < at.x ? std::max(out.left, x) : std::min(out.right, x);
    }
  }
  return out;
}

// Lines that fan out from below the front of a box: new ones begin inside it all the way up, each
// where the next ones on both sides have little more than one gap between them.
TEST(Tips, LeaveNoHolesBeforeThem) {
  constexpr double kWide = 60, kHigh = 60;
  Stage stage(test::box({0, 0, 0}, {kWide, 5, kHigh}), "front", 1);
  const Field fan{"fan", [](const FieldQuery& q) -> std::optional<Cross> {
                    const Vec3 p = q.point.position;
                    const Vec3 up = glm::normalize(Vec3(p.x - 0.5 * kWide, 0, p.z + 12));
                    return Cross{.first = up, .second = {up.z, 0, -up.x}, .certainty = 1};
                  }};
  const StrokeResult r = stage.strokes(fan, 0.7, kTipFamily);
  std::vector<double> holes;  // gaps
  for (const Curve3& c : r.strokes) {
    const Vec3 p = c.points.front().z < c.points.back().z ? c.points.front() : c.points.back();
    if (p.z < 1 || p.x < 0.3 * kWide || p.x > 0.7 * kWide) continue;
    const Passing beside = passing(r, &c, p);
    holes.push_back((beside.right - beside.left) / kGap);
  }
  ASSERT_GT(holes.size(), 8U);
  std::ranges::sort(holes);
  EXPECT_LT(holes[holes.size() / 2], 1.1);  // 1.23 where each went on for 0.7 mm and no more
  EXPECT_LT(holes.back(), 1.5);             // 1.59
  EXPECT_GT(holes.front(), 0.5);            // nor do they run into the next ones
}

// Wide strokes that run into the upper border of a face at 12 degrees: their corners stay inside.
TEST(Tips, AreNoTeethAlongABorder) {
  constexpr double kHigh = 40, kSlant = 12 * std::numbers::pi / 180;
  Stage stage(test::box({0, 0, 0}, {60, 5, kHigh}), "front", 1);
  const Vec3 along(std::cos(kSlant), 0, std::sin(kSlant));
  const StrokeResult r = stage.strokes(field::fixed(along), 0.4, kTipFamily);
  std::size_t ends = 0;
  for (const Curve3& c : r.strokes) {
    for (const bool begin : {true, false}) {
      const Vec3 p = begin ? c.points.front() : c.points.back();
      if (p.z < kHigh - 0.01 || p.x > 50) continue;
      ++ends;
      const double middle = c.widths[c.widths.size() / 2];
      EXPECT_GT(middle, 0.45);
      double above = 0, inside = 0;  // of corners; the widest near the end
      for (std::size_t i = 0; i < c.points.size(); ++i) {
        above = std::max(above, c.points[i].z + 0.5 * c.widths[i] * std::cos(kSlant) - kHigh);
        if (c.points[i].z < kHigh - 0.5) inside = std::max(inside, c.widths[i]);
      }
      EXPECT_LT(above, 0.07);  // 0.24 where each was cut square
      EXPECT_GT(inside, 0.45);
    }
  }
  EXPECT_GT(ends, 5U);
}

// The places of neighbours are out of step by up to half a step, which is as much as lines near a
// contour are apart.
TEST(SampleGrid, FindsNearNeighboursThatAreOutOfStep) {
  constexpr double kStep = 0.4, kNear = 0.12;
  for (const double shift : {0.0, 0.1, 0.2}) {
    SampleGrid grid({0, 0}, {10, 10}, 2);
    for (int line = 0; line < 5; ++line) {
      for (int i = 0; i < 20; ++i) {
        GridSample s;
        s.paper = {i * kStep + (line == 2 ? 0 : shift), 4 + line * kNear};
        s.direction = {1, 0};
        s.pace = 0.6 * kStep;
        s.part = s.region = 0;
        s.stroke = line;
        grid.insert(s);
      }
    }
    GridSample at;
    at.paper = {10 * kStep, 4 + 2 * kNear};
    at.direction = {1, 0};
    at.part = at.region = 0;
    at.stroke = 2;
    const SampleGrid::Sides sides = grid.sides(at, 1);
    EXPECT_NEAR(sides.left, kNear, 1e-9) << shift;
    EXPECT_NEAR(sides.right, kNear, 1e-9) << shift;
  }
}

}  // namespace
}  // namespace burin
