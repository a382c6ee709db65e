// What broken views find in their parts, and what of these they refuse or tell.
#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/mesh_checks.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

class BrokenParts : public testing::Test {
 protected:
  void SetUp() override {
    scene_ = {};
    scene_.parts = {part("bar", {0, 0, 0}, {20, 20, 400})};
    plan_ = {};
    plan_.view.paper = {297, 210};
    plan_.view.direction = {0, -1, 0};
    plan_.breaks = {along_z(50, 350)};
  }
  static Part part(const std::string& name, Vec3 low, Vec3 high) {
    return {name, "a.step", std::make_shared<MeshForm>(test::box(low, high))};
  }
  static Break along_z(double from, double to) {
    return {.axis = Vec3(0, 0, 1), .stretch = std::pair(from, to)};
  }
  void draw() {
    arrange_parts(scene_, plan_, context_);
    sheet_ = plan_sheet(scene_, plan_);
    drawing_ = illustrate(scene_, sheet_, plan_, context_);
  }
  /// The messages of that code.
  std::string told(const std::string& code) const {
    std::string all;
    for (const Diagnostics* from : {&scene_.diagnostics, &drawing_.diagnostics}) {
      for (const Diagnostic& one : from->entries()) all += one.code == code ? one.message : "";
    }
    return all;
  }
  const PlacedView& named(const std::string& name) const {
    return *std::ranges::find(sheet_.views, name, &PlacedView::name);
  }
  std::vector<std::string> dimensions() const {
    std::vector<std::string> texts;
    for (const Layer& layer : drawing_.layers) {
      for (const Text& text : layer.texts) {
        if (layer.name == "dimensions") texts.push_back(text.text);
      }
    }
    return texts;
  }

  Scene scene_;
  Illustration plan_;
  SheetOfViews sheet_;
  Drawing drawing_;
  RunContext context_;
};

TEST_F(BrokenParts, RefuseDetailsThatReachIntoTheBreak) {
  plan_.details = {{.at = {10, 0, 40}, .radius = 15}};
  EXPECT_THROW(draw(), UsageError);
  // Across all of it.
  plan_.breaks = {along_z(50, 60)};
  plan_.details = {{.at = {10, 0, 45}, .radius = 40}};
  EXPECT_THROW(draw(), UsageError);
  plan_.details = {{.at = {10, 0, 40}, .radius = 9}};
  draw();
  EXPECT_EQ(sheet_.details.size(), 1U);
}

TEST_F(BrokenParts, StayWholeInAViewThatHasNothingToLeaveOut) {
  // So wide that a slanted view shows something else beside all of the stretch, but for rounding.
  for (const double nudge : {0.0, 1e-9}) {
    scene_.parts = {part("bar", {0, 0, 0}, {200, 200 - nudge, 400})};
    plan_.breaks = {along_z(100, 300)};
    plan_.views = {"front", "iso"};
    draw();
    EXPECT_EQ(named("front").breaks.bands.size(), 1U);
    EXPECT_TRUE(named("iso").breaks.empty()) << nudge;
    EXPECT_EQ(told("break.short"), "");
  }
}

TEST_F(BrokenParts, AreFoundInPartsThatAreCut) {
  for (const bool quarter : {false, true}) {
    SetUp();
    scene_.parts = {{"shaft", "a.step", std::make_shared<MeshForm>(test::cylinder(10, 400, 64))}};
    plan_.breaks = {{}};
    Section& section = plan_.sections.emplace_back();
    section.planes = {{.axis = {0, 1, 0}, .side = -1, .offset = 0.3}};
    if (quarter) section.planes.push_back({.axis = {1, 0, 0}, .side = 1, .offset = 0.3});
    draw();
    ASSERT_EQ(plan_.left_out.stretches.size(), 1U) << told("break.not_found");
    const auto [low, high] = plan_.left_out.stretches[0];
    EXPECT_NEAR(high - low, 400 - 2 * 30, 2) << "one and a half of its width at each end";
  }
}

}  // namespace
}  // namespace burin
