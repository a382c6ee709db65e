// What broken views find in their parts, and what of these they refuse or tell.
#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>

#include "broken_bar.h"

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

class BrokenParts : public test::BrokenBar {
 protected:
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

TEST_F(BrokenParts, TellOfThoseThatAreLeftOut) {
  scene_.parts.push_back(part("ring", {-5, -5, 100}, {25, 25, 120}));
  scene_.parts.push_back(part("cap", {-5, -5, 340}, {25, 25, 360}));
  draw();
  EXPECT_NE(told("break.parts").find("all of 'ring':"), std::string::npos) << told("break.parts");
  // A view along the axis shows it.
  plan_.views = {"front", "top"};
  scene_.diagnostics = {};
  draw();
  EXPECT_EQ(told("break.parts"), "");
}

TEST_F(BrokenParts, TellOfBreaksThatEndOnFaces) {
  scene_.parts.push_back(part("collar", {-5, -5, 30}, {25, 25, 50}));
  plan_.views = {"front", "left"};
  draw();
  EXPECT_NE(told("break.on_face").find("at 50 mm"), std::string::npos) << told("break.on_face");
  plan_.breaks = {along_z(52, 350)};
  draw();
  EXPECT_EQ(told("break.on_face"), "");
}

TEST_F(BrokenParts, NameAStretchThatEndsBesideFaces) {
  scene_.parts.clear();
  for (int i = 0; i < 8; ++i) {
    const double side = i % 2 == 0 ? 100 : 60, low = 50 * i;
    scene_.parts.push_back(part("step", {0, 0, low}, {side, side, low + 50}));
  }
  plan_.breaks = {{.axis = Vec3(0, 0, 1)}};
  draw();
  // Faces are at 100 and 300.
  const std::string told_so = told("break.not_found");
  EXPECT_NE(told_so.find("as z:87.5..287.5"), std::string::npos) << told_so;
}

TEST_F(BrokenParts, MeasureAcrossWhereAFeatureIsSeen) {
  scene_.parts = {{"shaft", "a.step", std::make_shared<MeshForm>(test::cylinder(10, 400, 64))}};
  DimensionRow row{.kind = DimensionRow::Kind::Diameter};
  row.of = {{.kind = FeatureRow::Kind::Face, .at = {10, 0, 200}}};
  plan_.dimensions = {row};
  draw();
  ASSERT_EQ(dimensions().size(), 1U) << told("dimensions.not_drawn");
  const std::vector<Dimension>& drawn = named("").dimensions.list;
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_NEAR(glm::distance(drawn[0].from, drawn[0].to), 20, 0.1);
  // Both ends are left out, and a piece between two breaks is not.
  scene_.parts.push_back(part("foot", {-30, -30, -60}, {30, 30, 0}));
  scene_.parts.push_back(part("head", {-30, -30, 400}, {30, 30, 460}));
  plan_.breaks = {along_z(-20, 100), along_z(150, 420)};
  draw();
  EXPECT_EQ(dimensions().size(), 1U) << told("dimensions.not_drawn");
  EXPECT_EQ(told("dimensions.not_drawn"), "");
  plan_.breaks = {along_z(-20, 420)};
  draw();
  EXPECT_TRUE(dimensions().empty());
  EXPECT_NE(told("dimensions.not_drawn").find("the break leaves out"), std::string::npos);
}

TEST_F(BrokenParts, HaveNoOverallDimensionOfWhatIsLeftOut) {
  scene_.parts.push_back(part("flange", {-20, -20, 180}, {40, 40, 200}));
  plan_.overall_dimensions = true;
  draw();
  EXPECT_EQ(dimensions(), (std::vector<std::string>{"400"}));
  EXPECT_NE(told("dimensions.not_drawn").find("the width has no dimension: the break"),
            std::string::npos)
      << told("dimensions.not_drawn");
  // A view that is whole shows it.
  plan_.views = {"front", "top"};
  scene_.diagnostics = {};
  draw();
  std::vector<std::string> texts = dimensions();
  std::ranges::sort(texts);
  EXPECT_EQ(texts, (std::vector<std::string>{"400", "60", "60"}));
  EXPECT_EQ(told("dimensions.not_drawn"), "");
}

}  // namespace
}  // namespace burin
