// Arrows are parts in space: where they stand, what they hide, how they look.
#include <burin/base/error.h>
#include <burin/illustrate/illustrate.h>

#include "measured_sheet.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <burin_test/brep_shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace burin {
namespace {

class Arrows : public test::MeasuredSheet {
 protected:
  /// 40 x 40 x 10, and a block of 10 on it, the diagonal about 60.
  void SetUp() override {
    begin({"plate", "a.step", test::brep_form(BRepPrimAPI_MakeBox(40, 40, 10).Shape())});
    scene_.parts.push_back(
        {"block", "a.step",
         test::brep_form(BRepPrimAPI_MakeBox(gp_Pnt(15, 15, 10), 10, 10, 10).Shape())});
    plan_.view.direction = {1, -1, 1};
  }
  /// The box of the only arrow.
  Box3 arrow() {
    planned();
    EXPECT_EQ(scene_.parts.size(), 3U);
    return scene_.parts.back().form->bounds(Mat3(1));
  }
};

TEST_F(Arrows, StandBeforeTheirPartTheWayThatItMoves) {
  plan_.arrows = {{.select = {"block"}, .along = Vec3(0, 0, 5), .length = 12}};
  const Box3 box = arrow();
  EXPECT_EQ(scene_.parts.back().name, "arrow 1");
  EXPECT_GT(box.min.z, 20);
  EXPECT_LT(box.min.z, 23);
  EXPECT_NEAR(box.size().z, 12, 1e-9);
  EXPECT_NEAR(box.center().x, 20, 1e-9);
  EXPECT_NEAR(box.center().y, 20, 1e-9);
  // Flat across the line of sight.
  EXPECT_NEAR(box.size().x, box.size().y, 1e-9);
}

TEST_F(Arrows, BehindEndAtTheirPart) {
  plan_.arrows = {
      {.select = {"block"}, .along = Vec3(0, 0, -1), .behind = true, .length = 12, .width = 2}};
  const Box3 box = arrow();
  EXPECT_GT(box.min.z, 20);  // it comes from above
  EXPECT_NEAR(box.size().z, 12, 1e-9);
}

TEST_F(Arrows, BetweenTwoPointsAreThere) {
  plan_.arrows = {{.from = Vec3(-10, 0, 0), .to = Vec3(-10, 30, 0), .width = 2}};
  const Box3 box = arrow();
  EXPECT_NEAR(box.min.y, 0, 1e-9);
  EXPECT_NEAR(box.max.y, 30, 1e-9);
  EXPECT_NEAR(glm::length(Vec2(box.size().x, box.size().z)), 2.2 * 2, 1e-9);
}

/// Seen along the axis a ring, from its side a band; both turn by the right hand.
TEST_F(Arrows, AboutAnAxisAreARingOrABand) {
  for (const bool ring : {true, false}) {
    for (const double degrees : {90.0, -90.0}) {
      SetUp();
      plan_.view.direction = ring ? Vec3(0.1, -0.2, 1) : Vec3(0, -1, 0);
      plan_.view.up = ring ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
      plan_.arrows = {
          {.select = {"block"}, .about = Vec3(0, 0, 2), .degrees = degrees, .width = 2}};
      const Box3 box = arrow();
      EXPECT_NEAR(box.size().z, ring ? 0 : 2 * 2.2, 1e-9);
      EXPECT_EQ(box.min.z > 20, ring);
      const auto surface = scene_.parts.back().form->realise({}, context_);
      const std::vector<Vec3>& points = surface->proxy().mesh.positions;
      // The tip comes last: of a turn to the left it is at the left of the middle.
      const Vec3 tip = points[points.size() - 1] - Vec3(20, 20, 0);
      const Vec3 start = points[0] - Vec3(20, 20, 0);
      EXPECT_GT(degrees * cross2(Vec2(start), Vec2(tip)), 0);
    }
  }
}

TEST_F(Arrows, OfStepsShowTheWayBack) {
  plan_.explode.wanted = true;
  plan_.explode.steps = {{.move = {"block"}, .along = Vec3(0, 0, 1), .by = 60}};
  plan_.step_arrows = true;
  const Box3 box = arrow();
  EXPECT_LT(box.max.z, 70);  // below the block, and above the plate
  EXPECT_GT(box.min.z, 10);
  const PartStyle& look = plan_.illustrate.part_styles.back();
  EXPECT_FALSE(look.listed);
  EXPECT_FALSE(look.hatched);
  EXPECT_EQ(look.style->fill.color, "none");
}

TEST_F(Arrows, HideWhatIsBehindThem) {
  plan_.view.direction = {0, -1, 0};
  plan_.arrows = {{.from = Vec3(-20, -5, 5), .to = Vec3(60, -5, 5), .width = 8}};
  const SheetOfViews sheet = planned();
  const Drawing drawing =
      illustrate(scene_, sheet.camera(), plan_.style, plan_.illustrate, context_);
  // Of the left edge of the plate only what is above and below the shaft is seen.
  double seen = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.source.part != 0 || !path.visible) continue;
      for (std::size_t i = 0; i + 1 < path.points3.size(); ++i) {
        const Vec3 a = path.points3[i], b = path.points3[i + 1];
        if (std::abs(a.x) < 1e-6 && std::abs(b.x) < 1e-6) seen += std::abs(a.z - b.z);
      }
    }
  }
  EXPECT_NEAR(seen, 2, 0.2);
}

TEST_F(Arrows, OfPartsThatAreNotThereAreRefused) {
  plan_.arrows = {{.select = {"bolt"}, .along = Vec3(0, 0, 1), .place = "a.json:3: "}};
  try {
    planned();
    FAIL();
  } catch (const UsageError& e) {
    EXPECT_EQ(std::string(e.what()).find("a.json:3: "), 0U) << e.what();
  }
}

}  // namespace
}  // namespace burin
