// Dimensions stand where the view shows what they measure.
#include <burin/arrange/arrange.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <burin_test/brep_shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace burin {
namespace {

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

class SeenDimensions : public testing::Test {
 protected:
  using Kind = DimensionRow::Kind;
  using Texts = std::map<std::string, std::vector<std::string>>;

  static FeatureRow at(Vec3 p) { return {.at = p}; }
  void SetUp() override {
    scene_ = {};
    plan_ = {};
    scene_.parts = {{"plate", "a.step", test::brep_form(drilled_plate())}};
    plan_.view.paper = {297, 210};
    plan_.style.feature.crease_angle = 30;
  }

  DimensionRow& add(Kind kind, std::vector<FeatureRow> of) {
    DimensionRow row;
    row.kind = kind;
    row.of = std::move(of);
    return plan_.dimensions.emplace_back(row);
  }
  std::vector<PlacedView> views() {
    arrange_parts(scene_, plan_, context_);
    return plan_sheet(scene_, plan_).views;
  }
  Texts texts() {
    Texts texts;
    for (const PlacedView& view : views()) {
      for (const Dimension& one : view.dimensions.list) texts[view.name].push_back(one.text);
    }
    return texts;
  }
  std::string told(const char* code = "dimensions.not_drawn") const {
    for (const Diagnostic& one : scene_.diagnostics.entries()) {
      if (one.code == code) return one.message;
    }
    return "";
  }

  Scene scene_;
  Illustration plan_;
  RunContext context_;
};

TEST_F(SeenDimensions, BeginAtTheEndOfAnAxisThatIsSeen) {
  for (const double height : {12.0, 0.0}) {
    SetUp();
    plan_.view.direction = {1, -1, height > 0 ? 1 : -1};
    plan_.view.up = {0, 0, 1};
    add(Kind::Distance, {at({28.5, 15, 6}), at({0, 5, 2})});
    add(Kind::Distance, {at({40, 0, 2}), at({28.5, 15, 6})});
    add(Kind::Distance, {at({28.5, 15, 6}), at({63.25, 40, 8})}).along = Vec3(1, 0, 0);
    const std::vector<Dimension> list = views().front().dimensions.list;
    ASSERT_EQ(list.size(), 3U);
    for (const std::vector<Vec3>& points :
         {list[0].from_points, list[1].to_points, list[2].from_points}) {
      ASSERT_FALSE(points.empty());
      for (const Vec3& p : points) {
        EXPECT_NEAR(p.x, 20, 1e-9);
        EXPECT_NEAR(p.z, height, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace burin
