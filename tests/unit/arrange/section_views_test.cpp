// Sections that have views of their own.
#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/drawing/clip.h>
#include <burin/drawing/font.h>
#include <burin/forms/mesh/mesh_form.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <burin_test/brep_shapes.h>
#include <burin_test/mesh_checks.h>
#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace burin {
namespace {

class SectionViews : public testing::Test {
 protected:
  void SetUp() override {
    scene_.parts = {part("plate", {0, 0, 0}, {60, 40, 10}),
                    part("block", {10, 5, 10}, {30, 20, 30})};
    plan_.view.paper = {297, 210};
    plan_.views = {"front", "top"};
  }
  static Part part(const std::string& name, Vec3 low, Vec3 high) {
    return {name, "a.step", std::make_shared<MeshForm>(test::box(low, high))};
  }
  static Section at(Vec3 axis, int side, double offset) {
    Section section;
    section.planes = {{.axis = axis, .side = side, .offset = offset}};
    section.own_view = true;
    return section;
  }
  SheetOfViews planned() {
    arrange_parts(scene_, plan_, context_);
    return plan_sheet(scene_, plan_);
  }
  const PlacedView& view_of(const SheetOfViews& sheet, const std::string& name) {
    const auto found = std::ranges::find(sheet.views, name, &PlacedView::name);
    if (found == sheet.views.end()) throw std::runtime_error("no view " + name);
    return *found;
  }
  bool tells(const std::string& code) const { return test::count_of(scene_.diagnostics, code) > 0; }

  Scene scene_;
  Illustration plan_;
  RunContext context_;
};

/// How many lines of cut areas lie in a box.
int hatching_in(const Drawing& drawing, const Box2& box) {
  int count = 0;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      count += path.kind == LineClass::Pattern && box.contains(path.points.front()) ? 1 : 0;
    }
  }
  return count;
}

TEST_F(SectionViews, AloneAreCut) {
  plan_.sections = {at({0, 1, 0}, -1, 12)};
  const SheetOfViews sheet = planned();
  ASSERT_EQ(sheet.views.size(), 3U);
  EXPECT_EQ(sheet.views.back().name, "A-A");
  const Drawing drawing = illustrate(scene_, sheet, plan_, context_);
  EXPECT_EQ(hatching_in(drawing, view_of(sheet, "front").box), 0);
  EXPECT_EQ(hatching_in(drawing, view_of(sheet, "top").box), 0);
  EXPECT_GT(hatching_in(drawing, view_of(sheet, "A-A").box), 5);
}

TEST_F(SectionViews, AreMarkedWhereTheyCutInTheViewThatSeesTheirEdge) {
  plan_.sections = {at({0, 1, 0}, -1, 12)};
  const SheetOfViews sheet = planned();
  ASSERT_EQ(sheet.section_marks.size(), 1U);
  const SectionMark& mark = sheet.section_marks.front();
  const Camera& top = view_of(sheet, "top").camera;
  const Vec2 left = top.to_paper({0, 12, 0}), right = top.to_paper({60, 12, 0});
  ASSERT_EQ(mark.course.size(), 2U);
  const auto [first, last] =
      std::minmax(mark.course[0], mark.course[1], [](Vec2 a, Vec2 b) { return a.x < b.x; });
  EXPECT_NEAR(first.y, left.y, 1e-9);
  EXPECT_NEAR(last.y, left.y, 1e-9);
  const double beyond = section_reach(plan_.style.callout).beyond;
  EXPECT_NEAR(first.x, left.x - beyond, 1e-9);
  EXPECT_NEAR(last.x, right.x + beyond, 1e-9);
  // It is looked at from the front: upwards in a view from above.
  EXPECT_NEAR(mark.sight.x, 0, 1e-12);
  EXPECT_NEAR(mark.sight.y, 1, 1e-12);
}

TEST_F(SectionViews, GoRoundTheCornersOfSteps) {
  Section steps;
  steps.planes = {{.axis = {0, 1, 0}, .side = -1, .offset = 12},
                  {.axis = {1, 0, 0}, .offset = 40},
                  {.axis = {0, 1, 0}, .side = -1, .offset = 30}};
  steps.steps = steps.own_view = true;
  plan_.sections = {steps};
  const SheetOfViews sheet = planned();
  ASSERT_EQ(sheet.section_marks.size(), 1U);
  const std::vector<Vec2>& course = sheet.section_marks.front().course;
  const Camera& top = view_of(sheet, "top").camera;
  ASSERT_EQ(course.size(), 4U);
  EXPECT_NEAR(glm::distance(course[1], top.to_paper({40, 12, 0})), 0, 1e-9);
  EXPECT_NEAR(glm::distance(course[2], top.to_paper({40, 30, 0})), 0, 1e-9);
}

// The outline of a drill that is cut along its axis and the edge of the step meet in the corners of
// the cut face; they are different lines.
TEST_F(SectionViews, OfRoundPartsHaveNoLineAtAStep) {
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 20, -5), gp_Dir(0, 0, 1)), 4.25, 50).Shape();
  scene_.parts = {{"plate", "a.step",
                   test::brep_form(BRepAlgoAPI_Cut(test::box_shape(100, 60, 20), drill).Shape())}};
  plan_.views = {};
  plan_.view.direction = {0, -1, 0};
  Section steps;
  steps.planes = {{.axis = {0, 1, 0}, .side = -1, .offset = 20},
                  {.axis = {1, 0, 0}, .side = 1, .offset = 35},
                  {.axis = {0, 1, 0}, .side = -1, .offset = 45}};
  steps.steps = true;
  plan_.sections = {steps};
  const Drawing drawing = illustrate(std::move(scene_), std::move(plan_), context_);
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      EXPECT_FALSE(
          path.visible &&
          std::ranges::all_of(path.points3, [](Vec3 p) { return std::abs(p.x - 35) < 1e-6; }))
          << to_string(path.kind);
    }
  }
}

TEST_F(SectionViews, StandInTheFreePlaceOfTheViewFromTheirSide) {
  plan_.views = {"top"};
  plan_.sections = {at({0, 1, 0}, -1, 12), at({0, 1, 0}, -1, 30)};
  const SheetOfViews sheet = planned();
  const PlacedView &a = view_of(sheet, "A-A"), &b = view_of(sheet, "B-B"),
                   &top = view_of(sheet, "top");
  // First angle: the front over the view from above, of which it has the column.
  const Vec3 middle{30, 20, 15};
  EXPECT_NEAR(a.camera.to_paper(middle).x, top.camera.to_paper(middle).x, 1e-9);
  EXPECT_GT(a.box.min.y, top.box.max.y);
  EXPECT_FALSE(a.box.overlaps(b.box));
  EXPECT_FALSE(top.box.overlaps(b.box));
  EXPECT_DOUBLE_EQ(a.camera.scale(), top.camera.scale());
}

TEST_F(SectionViews, BringTheViewThatSeesTheirEdgeWhereNoneIsNamed) {
  plan_.views = {};
  plan_.sections = {at({0, 1, 0}, 0, 12)};
  SheetOfViews sheet = planned();
  std::vector<std::string> names;
  for (const PlacedView& view : sheet.views) names.push_back(view.name);
  EXPECT_EQ(names, (std::vector<std::string>{"top", "view", "A-A"}));
  EXPECT_EQ(sheet.section_marks.size(), 1U);
  // The view from above that is asked for sees the edge itself, and the cut is seen from the front.
  SetUp();
  plan_.views = {};
  plan_.view.direction = {0, 0, 1};
  plan_.view.up = {0, 1, 0};
  sheet = planned();
  ASSERT_EQ(sheet.views.size(), 2U);
  EXPECT_NEAR(sheet.views.back().camera.direction().y, -1, 1e-12);
}

TEST_F(SectionViews, HaveLettersThatNothingElseHas) {
  plan_.sections = {at({0, 1, 0}, -1, 12), at({1, 0, 0}, 1, 20), at({1, 0, 0}, 1, 30)};
  plan_.sections[1].letter = "A";
  plan_.details = {{.at = {0, 0, 0}, .radius = 4, .letter = "C"}, {.at = {9, 0, 0}, .radius = 4}};
  const SheetOfViews sheet = planned();
  std::vector<std::string> names;
  for (const SectionName& name : sheet.section_names) names.push_back(name.letter);
  EXPECT_EQ(names, (std::vector<std::string>{"B", "A", "D"}));
  ASSERT_EQ(sheet.details.size(), 2U);
  EXPECT_EQ(sheet.details[0].letter, "C");
  EXPECT_EQ(sheet.details[1].letter, "E");
  plan_.details[0].letter = "A";
  EXPECT_THROW(arrange_parts(scene_, plan_, context_), UsageError);
}

TEST_F(SectionViews, SayWhereTheSheetDoesNotShowTheirLine) {
  plan_.views = {"front", "back"};
  plan_.sections = {at({0, 1, 0}, -1, 12)};
  const SheetOfViews sheet = planned();
  EXPECT_TRUE(sheet.section_marks.empty());
  EXPECT_EQ(sheet.section_names.size(), 1U);
  EXPECT_TRUE(tells("section.no_line"));
}

TEST_F(SectionViews, AreCutByPlanesOrStepsAlone) {
  Section quarter;
  quarter.planes = {{.axis = {0, 1, 0}}, {.axis = {1, 0, 0}}};
  quarter.own_view = true;
  plan_.sections = {quarter};
  EXPECT_THROW(arrange_parts(scene_, plan_, context_), UsageError);
}

TEST_F(SectionViews, KeepMarksAndNamesOnTheSheetAndOffTheViews) {
  for (const double width : {420.0, 297.0, 210.0}) {
    SetUp();
    plan_.view.paper = {width, width / std::sqrt(2.0)};
    plan_.sections = {at({0, 1, 0}, -1, 12), at({1, 0, 0}, -1, 20)};
    const SheetOfViews sheet = planned();
    const Drawing drawing = illustrate(scene_, sheet, plan_, context_);
    const auto marks = std::ranges::find(drawing.layers, "section-marks", &Layer::name);
    ASSERT_NE(marks, drawing.layers.end());
    const Box2 paper{Vec2(0), {drawing.paper_width, drawing.paper_height}};
    for (const Text& text : marks->texts) {
      const Box2 box = text_box(text);
      EXPECT_TRUE(paper.contains(box.min) && paper.contains(box.max)) << text.text;
      for (const Layer& layer : drawing.layers) {
        if (layer.name.starts_with("section")) continue;
        for (const Path& path : layer.paths) {
          EXPECT_TRUE(clipped(path, box).empty()) << text.text << " over " << layer.name;
        }
      }
    }
    EXPECT_EQ(marks->texts.size(), 6U);
  }
}

TEST_F(SectionViews, OfOnePlaceKeepTheirLettersApart) {
  plan_.sections = {at({0, 1, 0}, -1, 12), at({0, 1, 0}, -1, 12), at({0, 1, 0}, -1, 13)};
  const Drawing drawing = illustrate(scene_, planned(), plan_, context_);
  const auto marks = std::ranges::find(drawing.layers, "section-marks", &Layer::name);
  ASSERT_NE(marks, drawing.layers.end());
  EXPECT_EQ(marks->texts.size(), 9U);
  for (const Text& a : marks->texts) {
    for (const Text& b : marks->texts) {
      EXPECT_TRUE(&a == &b || !text_box(a).overlaps(text_box(b))) << a.text << " over " << b.text;
    }
  }
}

TEST_F(SectionViews, WithAStepBeyondTheModelAreRefused) {
  for (const double end : {100.0, -5.0}) {
    Section steps;
    steps.planes = {{.axis = {0, 1, 0}, .side = -1, .offset = 12},
                    {.axis = {1, 0, 0}, .offset = end},
                    {.axis = {0, 1, 0}, .side = -1, .offset = 30}};
    steps.steps = steps.own_view = true;
    plan_.sections = {steps};
    EXPECT_THROW(arrange_parts(scene_, plan_, context_), UsageError) << end;
  }
}

TEST_F(SectionViews, ComeApartAsTheOthersDo) {
  plan_.sections = {at({0, 1, 0}, -1, 12)};
  plan_.explode.wanted = true;
  plan_.explode.steps = {{.move = {"block"}, .by = 10}};
  const SheetOfViews sheet = planned();
  const PlacedView& view = view_of(sheet, "A-A");
  ASSERT_TRUE(view.scene);
  EXPECT_NEAR(view.scene->parts[1].form->bounds(Mat3(1)).min.z, 20, 1e-9);
  EXPECT_TRUE(sheet.section_marks.empty());
  EXPECT_TRUE(tells("section.no_line"));
}

}  // namespace
}  // namespace burin
