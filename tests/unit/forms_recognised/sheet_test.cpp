#include <burin/base/rng.h>

#include <gtest/gtest.h>
#include <sheet.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace burin::recognised {
namespace {

constexpr std::int32_t kSteps = 16, kSlices = 81;
constexpr double kStep = 18.75 * std::numbers::pi / 180, kLongest = 33;

// A spring as an outline that is extruded and twisted: a band of 300 degrees around the axis, 20 mm
// wide, whose steps are as long as the way from slice to slice. Cells are 33 mm long both ways and
// 1.3 mm high.
PointGrid spring() {
  PointGrid grid;
  grid.rows = kSlices;
  grid.columns = 2 * kSteps;
  grid.columns_close = true;
  for (std::int32_t j = 0; j < kSlices; ++j) {
    grid.row_knots.push_back(kLongest * j);
    for (std::int32_t i = 0; i < grid.columns; ++i) {
      const std::int32_t step = i <= kSteps ? i : grid.columns - i;
      const double along = std::clamp(2.0 * step / kSteps - 1, -1.0, 1.0);
      const double r = 100 + (i <= kSteps ? 10 : -10) * std::sqrt(1 - along * along);
      const double angle = kStep * (step + j);
      grid.points.push_back({r * std::cos(angle), r * std::sin(angle), 1.25 * j});
    }
  }
  for (std::int32_t i = 0; i <= grid.columns; ++i) grid.column_knots.push_back(kLongest * i);
  return grid;
}

TEST(Sheet, FindsThePlaceOfItsPointsHoweverSlantedItsCellsAre) {
  const PointGrid grid = spring();
  const Sheet sheet(grid);
  const Rng rng(7);
  double worst = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const Vec2 uv(rng.uniform(2 * i) * grid.column_knots.back(),
                  rng.uniform(2 * i + 1) * grid.row_knots.back());
    const Vec3 p = sheet.derivatives(uv).p;
    worst = std::max(worst, glm::distance(sheet.derivatives(sheet.locate(p, {})).p, p));
  }
  EXPECT_LT(worst, 1e-8);
}

// Along the longer diagonal they would be 6.8 mm and 168 degrees.
TEST(Sheet, MeasuresItsFacetsAlongTheShorterDiagonal) {
  const Sheet sheet(spring());
  EXPECT_LT(sheet.sagitta(), 5);
  EXPECT_LT(sheet.turn(), 30 * std::numbers::pi / 180);
}

}  // namespace
}  // namespace burin::recognised
