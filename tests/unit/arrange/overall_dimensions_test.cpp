// Width, depth and height of what a sheet shows.
#include <burin/arrange/arrange.h>
#include <burin/drawing/clip.h>
#include <burin/drawing/font.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/mesh_checks.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

class OverallDimensions : public testing::Test {
 protected:
  void SetUp() override {
    scene_ = {};
    plan_ = {};
    scene_.parts = {part("plate", {0, 0, 0}, {60, 40.125, 10}),
                    part("block", {10, 5, 10}, {30, 20, 30})};
    plan_.view.paper = {297, 210};
    plan_.overall_dimensions = true;
  }
  static Part part(const std::string& name, Vec3 low, Vec3 high) {
    return {name, "a.step", std::make_shared<MeshForm>(test::box(low, high))};
  }
  SheetOfViews planned() {
    arrange_parts(scene_, plan_, context_);
    return plan_sheet(scene_, plan_);
  }
  /// The texts of each view, by its name.
  std::map<std::string, std::vector<std::string>> texts() {
    std::map<std::string, std::vector<std::string>> texts;
    for (const PlacedView& view : planned().views) {
      for (const Dimension& one : view.dimensions.list) texts[view.name].push_back(one.text);
    }
    return texts;
  }
  bool tells() const { return test::count_of(scene_.diagnostics, "dimensions.not_drawn") > 0; }

  Scene scene_;
  Illustration plan_;
  RunContext context_;
};

using Texts = std::map<std::string, std::vector<std::string>>;

TEST_F(OverallDimensions, StandOnceEachInTheFirstViewThatIsSquareToThem) {
  plan_.views = {"front", "top", "left", "iso"};
  EXPECT_EQ(texts(), (Texts{{"front", {"60", "30"}}, {"top", {"40.12"}}}));
  EXPECT_FALSE(tells());
  plan_.views = {"iso", "left"};
  EXPECT_EQ(texts(), (Texts{{"iso", {"60"}}, {"left", {"40.12", "30"}}}));
}

TEST_F(OverallDimensions, OfALoneViewAreThoseThatItShows) {
  EXPECT_EQ(texts(), (Texts{{"", {"60", "40.12", "30"}}}));
  EXPECT_FALSE(tells());
  plan_.view.direction = {0, 0, 1};
  plan_.view.up = {0, 1, 0};
  EXPECT_EQ(texts(), (Texts{{"", {"60", "40.12"}}}));
  EXPECT_TRUE(tells());
}

TEST_F(OverallDimensions, AreWrittenAsTheStyleSays) {
  DimensionOptions style;
  EXPECT_EQ(dimension_text(80, style), "80");
  EXPECT_EQ(dimension_text(12.5, style), "12.5");
  EXPECT_EQ(dimension_text(100.0 / 3, style), "33.33");
  style.sign = DimensionOptions::Sign::Comma;
  style.decimals = 4;
  EXPECT_EQ(dimension_text(100.0 / 3, style), "33,3333");
  style.decimals = 0;
  EXPECT_EQ(dimension_text(100, style), "100");
}

TEST_F(OverallDimensions, HaveTheirArrowsAtTheEndsOfWhatTheyMeasure) {
  plan_.view.direction = {0, -1, 0};
  const SheetOfViews sheet = planned();
  const Drawing drawing = illustrate(scene_, sheet, plan_, context_);
  const auto layer = std::ranges::find(drawing.layers, "dimensions", &Layer::name);
  ASSERT_NE(layer, drawing.layers.end());
  const double left = sheet.camera().to_paper({0, 0, 0}).x,
               right = sheet.camera().to_paper({60, 0, 0}).x,
               foot = sheet.camera().to_paper({0, 0, 0}).y;
  std::vector<Vec2> tips;
  for (const Path& path : layer->paths) {
    if (path.width.size() == 2) tips.push_back(path.points.back());
  }
  ASSERT_EQ(tips.size(), 4U);
  EXPECT_NEAR(tips[0].x, left, 1e-9);
  EXPECT_NEAR(tips[1].x, right, 1e-9);
  EXPECT_NEAR(tips[0].y, foot - 2.4 * plan_.style.dimension.height, 1e-9);
  ASSERT_EQ(layer->texts.size(), 2U);
  EXPECT_EQ(layer->texts[0].turn, 0);
  EXPECT_EQ(layer->texts[1].turn, 90);  // read from the right
}

TEST_F(OverallDimensions, StandOffTheDrawingAndOnTheSheet) {
  for (const Vec3 direction : {Vec3(1, -1, 1), Vec3(0, -1, 0), Vec3(2, -1, 1), Vec3(-1, -2, 3)}) {
    for (const double width : {297.0, 105.0}) {
      SetUp();
      plan_.view.direction = direction;
      plan_.view.paper = {width, width / std::sqrt(2.0)};
      plan_.callouts = true;
      const Drawing drawing = illustrate(scene_, planned(), plan_, context_);
      const auto layer = std::ranges::find(drawing.layers, "dimensions", &Layer::name);
      ASSERT_NE(layer, drawing.layers.end());
      const Box2 paper{Vec2(0), {drawing.paper_width, drawing.paper_height}};
      for (const Path& path : layer->paths) {
        for (const Vec2& p : path.points) EXPECT_TRUE(paper.contains(p)) << p.x << " " << p.y;
      }
      for (const Text& text : layer->texts) {
        const Vec2 middle = text_box(text).center();
        const Box2 core{middle - Vec2(1), middle + Vec2(1)};
        for (const Layer& other : drawing.layers) {
          if (other.name == "dimensions" || other.name == "callouts") continue;
          for (const Path& path : other.paths) {
            EXPECT_TRUE(clipped(path, core).empty()) << text.text << " over " << other.name;
          }
        }
      }
    }
  }
}

/// A bar across the diagonal of its box, whose corners are bare.
TEST_F(OverallDimensions, KeepTheCornersOfTheBoxOnTheSheet) {
  TriMesh bar = test::box({-30, -4, 0}, {30, 4, 6});
  for (Vec3& p : bar.positions) p = {0.6 * p.x - 0.8 * p.y, 0.8 * p.x + 0.6 * p.y, p.z};
  scene_.parts = {{"bar", "a.step", std::make_shared<MeshForm>(bar)}};
  for (const Vec3 direction : {Vec3(1, -1, 1), Vec3(1, 1, 1), Vec3(0.87, 0.76, -0.8)}) {
    plan_.view.direction = direction;
    const Drawing drawing = illustrate(scene_, planned(), plan_, context_);
    const auto layer = std::ranges::find(drawing.layers, "dimensions", &Layer::name);
    ASSERT_NE(layer, drawing.layers.end());
    const Box2 frame{Vec2(9.9), Vec2(drawing.paper_width, drawing.paper_height) - 9.9};
    for (const Path& path : layer->paths) {
      for (const Vec2& p : path.points) EXPECT_TRUE(frame.contains(p)) << p.x << " " << p.y;
    }
  }
}

TEST_F(OverallDimensions, DoNotLieAboutWhatWasCutOrCameApart) {
  plan_.sections = {{.planes = {{.axis = {0, 1, 0}, .side = -1, .offset = 12}}}};
  EXPECT_EQ(texts(), (Texts{{"", {"60", "30"}}}));
  EXPECT_TRUE(tells());
  SetUp();
  plan_.explode.wanted = true;
  plan_.explode.steps = {{.move = {"block"}, .by = 10}};
  EXPECT_EQ(texts(), (Texts{{"", {"60", "40.12"}}}));
  EXPECT_TRUE(tells());
  SetUp();
  plan_.view.perspective = 40;
  EXPECT_EQ(texts(), Texts{});
  EXPECT_TRUE(tells());
}

}  // namespace
}  // namespace burin
