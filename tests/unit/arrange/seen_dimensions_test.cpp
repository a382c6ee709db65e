// Dimensions stand where the view shows what they measure.
#include "measured_sheet.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <burin_test/brep_shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin {
namespace {

using test::at;

TopoDS_Shape without_hole(const TopoDS_Shape& from, gp_Pnt point, gp_Dir way, double radius,
                          double depth) {
  return BRepAlgoAPI_Cut(from, BRepPrimAPI_MakeCylinder(gp_Ax2(point, way), radius, depth).Shape());
}

/// 80 x 50 x 12, with a hole through it, a blind one from above and one from the left.
TopoDS_Shape drilled_plate() {
  TopoDS_Shape out = BRepPrimAPI_MakeBox(80, 50, 12).Shape();
  out = without_hole(out, gp_Pnt(20, 15, -1), gp_Dir(0, 0, 1), 8.5, 20);
  out = without_hole(out, gp_Pnt(60, 40, 4), gp_Dir(0, 0, 1), 3.25, 20);
  return without_hole(out, gp_Pnt(-1, 40, 6), gp_Dir(1, 0, 0), 2.5, 11);
}

class SeenDimensions : public test::MeasuredSheet {
 protected:
  void SetUp() override { begin({"plate", "a.step", test::brep_form(drilled_plate())}); }

  std::vector<PlacedView> views() { return planned().views; }
};

TEST_F(SeenDimensions, BeginAtTheEndOfAnAxisThatIsSeen) {
  for (const double height : {12.0, 0.0}) {
    SetUp();
    plan_.view.direction = {1, -1, height > 0 ? 1 : -1};
    plan_.view.up = {0, 0, 1};
    add(Kind::Distance, {at({28.5, 15, 6}), at({0, 5, 2})});
    add(Kind::Distance, {at({40, 0, 2}), at({28.5, 15, 6})});
    if (height > 0) {
      add(Kind::Distance, {at({28.5, 15, 6}), at({63.25, 40, 8})}).along = Vec3(1, 0, 0);
    }
    const std::vector<Dimension> list = views().front().dimensions.list;
    EXPECT_EQ(list.size(), height > 0 ? 3U : 2U);
    for (const Dimension& one : list) {
      const bool first = std::ranges::all_of(one.from_points, [](Vec3 p) { return p.x == 20; });
      const std::vector<Vec3>& points = first ? one.from_points : one.to_points;
      ASSERT_FALSE(points.empty());
      for (const Vec3& p : points) {
        EXPECT_NEAR(p.x, 20, 1e-9);
        EXPECT_NEAR(p.z, height, 1e-9);
      }
    }
    EXPECT_EQ(told(), "");
  }
}

TEST_F(SeenDimensions, StandWhereNoPartHidesWhatTheyMeasure) {
  plan_.views = {"front", "top", "back"};
  add(Kind::Diameter, {at({5, 40, 8.5})});
  add(Kind::Depth, {at({5, 40, 8.5})});
  add(Kind::Depth, {at({63.25, 40, 8})});
  EXPECT_EQ(texts(), (Texts{{"top", {"⌀6.5 ↧ 8"}}}));
  EXPECT_EQ(told(),
            "dimension 1 (diameter) is not drawn: what it measures is hidden in the views front, "
            "top, back: add left to `views`");
  // Those with hidden lines after those where it is seen.
  SetUp();
  plan_.views = {"front", "left"};
  plan_.illustrate.hidden = HiddenLines::Dashed;
  add(Kind::Diameter, {at({5, 40, 8.5})});
  add(Kind::Depth, {at({5, 40, 8.5})});
  add(Kind::Depth, {at({63.25, 40, 8})});
  EXPECT_EQ(texts(), (Texts{{"front", {"8"}}, {"left", {"⌀5", "⌀5 ↧ 10"}}}));
  SetUp();
  plan_.views = {"front", "top"};
  plan_.hidden_views = {"front"};
  plan_.illustrate.hidden = HiddenLines::Dashed;
  add(Kind::Diameter, {at({5, 40, 8.5})});
  EXPECT_EQ(texts(), (Texts{{"front", {"⌀5"}}}));
}

TEST_F(SeenDimensions, AreDrawnWhereTheRowSaysWithAWarning) {
  plan_.views = {"front", "left"};
  add(Kind::Diameter, {at({5, 40, 8.5})}).view = "front";
  EXPECT_EQ(texts(), (Texts{{"front", {"⌀5"}}}));
  EXPECT_EQ(told("dimensions.hidden"),
            "dimension 1 (diameter) is drawn in the view front, where what it measures is hidden");
}

TEST_F(SeenDimensions, StandInTheSectionThatCutsWhatTheyMeasure) {
  plan_.views = {"front", "top"};
  plan_.sections = {{.planes = {{.axis = {0, 1, 0}, .side = -1, .offset = 40}}, .own_view = true}};
  add(Kind::Diameter, {at({5, 40, 8.5})});
  add(Kind::Depth, {at({5, 40, 8.5})});
  EXPECT_EQ(texts(), (Texts{{"A-A", {"⌀5", "10"}}}));
  EXPECT_EQ(told(), "");
}

TEST_F(SeenDimensions, AreNotOfWhatAnotherPartHides) {
  plan_.views = {"front", "top", "bottom"};
  scene_.parts.push_back(
      {"lid", "a.step",
       test::brep_form(BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 12), gp_Pnt(80, 50, 15)).Shape())});
  add(Kind::Diameter, {at({28.5, 15, 6})});
  add(Kind::Diameter, {at({63.25, 40, 8})});
  EXPECT_EQ(texts(), (Texts{{"bottom", {"⌀17"}}}));
  EXPECT_EQ(told(),
            "dimension 2 (diameter) is not drawn: what it measures is hidden in the views front, "
            "top, bottom: cut it open (`section`) or draw hidden lines (`hidden`)");
  // Glass hides nothing.
  plan_.illustrate.part_styles.resize(2);
  plan_.illustrate.part_styles[1].transparent = true;
  EXPECT_EQ(texts(), (Texts{{"top", {"⌀17", "⌀6.5"}}}));
}

/// The walls of a keyway end at the outline of the shaft from its end, which hides them.
TEST_F(SeenDimensions, AreNotOfWallsBehindAnOutline) {
  const gp_Ax2 axis(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0));
  TopoDS_Shape shaft = BRepPrimAPI_MakeCylinder(axis, 15, 100).Shape();
  shaft = BRepAlgoAPI_Cut(shaft,
                          BRepPrimAPI_MakeBox(gp_Pnt(40, -2.5, 10), gp_Pnt(60, 2.5, 20)).Shape());
  scene_.parts = {{"shaft", "a.step", test::brep_form(shaft)}};
  plan_.views = {"front", "left", "right"};
  add(Kind::Distance, {at({50, 2.5, 12}), at({50, -2.5, 12})});
  add(Kind::Distance, {at({40, 0, 12}), at({60, 0, 12})});
  // Of the ends of the keyway a corner is seen.
  EXPECT_EQ(texts(), (Texts{{"front", {"20"}}}));
  EXPECT_NE(told().find("add top to `views`"), std::string::npos) << told();
}

TEST_F(SeenDimensions, OfDepthAreOfHolesThatEndInTheirPart) {
  plan_.views = {"front", "top"};
  add(Kind::Depth, {at({28.5, 15, 6})});
  EXPECT_EQ(texts(), Texts{});
  EXPECT_EQ(told(),
            "dimension 1 (depth) is not drawn: the hole goes through its part, so it has no depth: "
            "measure its `diameter`, or the `distance` of the faces at its ends");
  // Aslant, through the wall of a tube, and from a larger hole at either end.
  const auto drawn = [&](const TopoDS_Shape& shape, Vec3 place) {
    SetUp();
    plan_.views = {"front", "top", "left"};
    scene_.parts = {{"part", "a.step", test::brep_form(shape)}};
    add(Kind::Depth, {at(place)});
    return !texts().empty();
  };
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(60, 40, 20).Shape();
  const gp_Pnt deep(10, 20, -10);
  EXPECT_FALSE(drawn(without_hole(block, deep, gp_Dir(1, 0, 1), 4, 60), {30, 16, 10}));
  TopoDS_Shape tube = without_hole(block, gp_Pnt(-1, 20, 10), gp_Dir(1, 0, 0), 8, 70);
  tube = without_hole(tube, gp_Pnt(30, 20, 15), gp_Dir(0, 0, 1), 2, 20);
  EXPECT_FALSE(drawn(tube, {32, 20, 19}));
  TopoDS_Shape stepped = without_hole(block, gp_Pnt(30, 20, -1), gp_Dir(0, 0, 1), 3, 30);
  stepped = without_hole(stepped, gp_Pnt(30, 20, 14), gp_Dir(0, 0, 1), 6, 30);
  EXPECT_FALSE(drawn(stepped, {33, 20, 5}));
  EXPECT_TRUE(drawn(stepped, {36, 20, 17}));  // the larger one ends at the smaller
  // With a round bottom.
  TopoDS_Shape round = without_hole(block, gp_Pnt(30, 20, 10), gp_Dir(0, 0, 1), 5, 30);
  round = BRepAlgoAPI_Cut(round, BRepPrimAPI_MakeSphere(gp_Pnt(30, 20, 10), 5).Shape());
  EXPECT_TRUE(drawn(round, {35, 20, 15}));
}

}  // namespace
}  // namespace burin
