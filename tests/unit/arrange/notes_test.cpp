// Notes point at what the view shows, and say what the model says.
#include <burin/base/error.h>

#include "measured_sheet.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <burin_test/brep_shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

using test::at;

FeatureRow part(const std::string& selector) {
  return {.kind = FeatureRow::Kind::Part, .part = selector};
}

Part box(const std::string& name, Vec3 low, Vec3 size) {
  const gp_Pnt corner(low.x, low.y, low.z);
  return {name, "a.step",
          test::brep_form(BRepPrimAPI_MakeBox(corner, size.x, size.y, size.z).Shape())};
}

class Notes : public test::MeasuredSheet {
 protected:
  /// A plate, and on it two blocks, the second in front of the first.
  void SetUp() override {
    begin(box("plate", {0, 0, 0}, {80, 50, 10}));
    scene_.parts.push_back(box("block 1", {30, 40, 10}, {10, 5, 10}));
    scene_.parts.push_back(box("block 2", {30, 5, 10}, {10, 5, 10}));
    plan_.views = {"front", "top"};
  }
  void note(const std::string& text, std::vector<FeatureRow> of) {
    DimensionRow row;
    row.kind = DimensionRow::Kind::Note;
    row.text = text;
    row.of = std::move(of);
    plan_.note_rows.push_back(row);
  }
  /// The notes of a view.
  std::vector<Dimension> in(const std::string& name) {
    for (const PlacedView& view : planned().views) {
      if (view.name == name) return view.dimensions.list;
    }
    return {};
  }
};

TEST_F(Notes, PointAtTheMiddleOfWhatIsSeenOfAFace) {
  note("milled", {at({5, 5, 10})});
  const std::vector<Dimension> front = in("front");
  EXPECT_TRUE(front.empty());  // seen from its edge there
  const std::vector<Dimension> top = in("top");
  ASSERT_EQ(top.size(), 1U);
  const LeaderTarget& target = top[0].targets.at(0);
  EXPECT_EQ(target.source.part, 0);
  EXPECT_GE(target.source.face, 0);
  ASSERT_FALSE(target.tips.empty());
  // The largest free disc is right of the blocks: about (60, 25), 20 mm from its borders.
  EXPECT_GT(target.rooms[0], 17);
  EXPECT_LE(target.rooms[0], 25);
  for (std::size_t k = 0; k < target.tips.size(); ++k) {
    const Vec3 p = target.tips[k];
    EXPECT_NEAR(p.z, 10, 1e-6);
    for (const double y : {5.0, 40.0}) {
      const bool on_block = p.x > 30 && p.x < 40 && p.y > y && p.y < y + 5;
      EXPECT_FALSE(on_block);
    }
    const double border = std::min({p.x, 80 - p.x, p.y, 50 - p.y});
    EXPECT_LE(target.rooms[k], border + 80.0 / 48);
  }
}

TEST_F(Notes, OfPartsThatASelectorNamesPointAtOneThatIsSeen) {
  plan_.views = {"front"};
  note("tap in", {part("block*")});
  const std::vector<Dimension> list = in("front");
  ASSERT_EQ(list.size(), 1U);
  for (const Vec3& p : list[0].targets.at(0).tips) EXPECT_NEAR(p.y, 5, 1e-6);
  EXPECT_EQ(told(), "");
}

TEST_F(Notes, SayWhereWhatTheyPointAtIsHidden) {
  plan_.views = {"front"};
  note("hidden", {part("block 1")});
  EXPECT_TRUE(in("front").empty());
  EXPECT_EQ(
      told(),
      "note 1 is not drawn: what it points at is hidden in the view front: add top to `views`");
}

TEST_F(Notes, PointAtTheRimOfAHoleThatIsSeenAlongItsAxis) {
  begin(
      {"plate", "a.step",
       test::brep_form(BRepAlgoAPI_Cut(
           BRepPrimAPI_MakeBox(80, 50, 10).Shape(),
           BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 15, -1), gp_Dir(0, 0, 1)), 8, 20).Shape()))});
  plan_.views = {"top"};
  note("reamed", {at({28, 15, 5})});
  const std::vector<Dimension> list = in("top");
  ASSERT_EQ(list.size(), 1U);
  for (const Vec3& p : list[0].targets.at(0).tips) {
    EXPECT_NEAR(glm::distance(Vec2(p), Vec2(20, 15)), 8, 0.05);
  }
}

/// What stands exactly behind something of its own outline is hidden.
TEST_F(Notes, AreNotAtPartsBehindEqualOnes) {
  begin({"plate", "a.step", test::brep_form(BRepPrimAPI_MakeBox(80, 50, 10).Shape())});
  for (const double y : {10.0, 40.0}) {
    const gp_Ax2 axis(gp_Pnt(40, y, 10), gp_Dir(0, 0, 1));
    scene_.parts.push_back({y < 20 ? "near" : "far", "a.step",
                            test::brep_form(BRepPrimAPI_MakeCylinder(axis, 6, 20).Shape())});
  }
  plan_.views = {"front", "top"};
  note("far", {part("far")});
  EXPECT_TRUE(in("front").empty());
  EXPECT_EQ(in("top").size(), 1U);
}

TEST_F(Notes, MoveWithTheirParts) {
  plan_.views = {"front"};
  plan_.explode.wanted = true;
  plan_.explode.steps = {{.move = {"block 2"}, .along = Vec3(0, 0, 1), .by = 50}};
  note("goes up", {part("block 2")});
  const std::vector<Dimension> list = in("front");
  ASSERT_EQ(list.size(), 1U);
  for (const Vec3& p : list[0].targets.at(0).tips) {
    EXPECT_GT(p.z, 60);
    EXPECT_LT(p.z, 70);
  }
}

TEST_F(Notes, FillTheirBracesFromTheModel) {
  const TopoDS_Shape drilled = BRepAlgoAPI_Cut(
      BRepPrimAPI_MakeBox(80, 50, 12).Shape(),
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, 15, -1), gp_Dir(0, 0, 1)), 8.5, 20).Shape());
  begin({"plate #2", "a.step", test::brep_form(drilled)});
  plan_.views = {"iso"};
  plan_.style.dimension.decimals = 6;
  note("{part.name}: {diameter}", {at({28.5, 15, 6})});
  note("{volume}", {part("plate*")});
  note("{length}", {{.kind = FeatureRow::Kind::Edge, .at = {28.5, 15, 12}}});
  note("{length} {item}", {{.kind = FeatureRow::Kind::Edge, .at = {40, 0, 12}}});
  std::vector<std::string> texts;
  for (const Dimension& one : in("iso")) texts.push_back(one.label->texts.at(0).text);
  ASSERT_EQ(texts.size(), 4U);
  EXPECT_EQ(texts[0], "plate: 17");
  EXPECT_NEAR(std::stod(texts[1]), 12 * (80 * 50 - std::numbers::pi * 8.5 * 8.5), 1e-5);
  EXPECT_NEAR(std::stod(texts[2]), 17 * std::numbers::pi, 1e-6);
  EXPECT_EQ(texts[3], "80 1");
}

TEST_F(Notes, RefuseWhatTheModelDoesNotHave) {
  note("{diameter}", {part("plate")});
  EXPECT_THROW(planned(), UsageError);
}

}  // namespace
}  // namespace burin
