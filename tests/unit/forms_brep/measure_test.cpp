/// Measures of CAD parts: those of the formulas, wherever the shape stands and however it was made.

#include <burin/assembly/items.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <burin_test/brep_shapes.h>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace burin {
namespace {

constexpr double kPi = std::numbers::pi;

/// An angle with a hole: no mirror plane.
TopoDS_Shape bracket() {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(gp_Pnt(0, 0, 0), gp_Pnt(30, 20, 10)).Shape();
  const TopoDS_Shape notch = BRepPrimAPI_MakeBox(gp_Pnt(12, -1, 4), gp_Pnt(31, 9, 11)).Shape();
  const TopoDS_Shape hole =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(6, 14, -1), gp_Dir(0, 0, 1)), 2.5, 12).Shape();
  return BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(block, notch).Shape(), hole).Shape();
}

/// A copy with geometry of its own, elsewhere.
TopoDS_Shape moved(const TopoDS_Shape& shape, bool mirrored) {
  gp_Trsf turn, shift, mirror;
  turn.SetRotation(gp_Ax1(gp_Pnt(3, 1, 2), gp_Dir(1, 2, 3)), 1.234);
  shift.SetTranslation(gp_Vec(500, -40, 7));
  if (mirrored) mirror.SetMirror(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)));
  return BRepBuilderAPI_Transform(shape, shift * turn * mirror, true).Shape();
}

TEST(BrepMeasure, OfACylinderIsThatOfTheFormulas) {
  RunContext context;
  const double r = 3, h = 8;
  const auto m = test::brep_form(BRepPrimAPI_MakeCylinder(r, h).Shape())->measure(context);
  EXPECT_NEAR(m.area, 2 * kPi * r * h + 2 * kPi * r * r, 1e-6);
  EXPECT_NEAR(m.volume, kPi * r * r * h, 1e-6);
  const double wall = 2 * kPi * r * h, lid = kPi * r * r;
  EXPECT_NEAR(m.moments.z, wall * h * h / 12 + 2 * lid * h * h / 4, 1e-5);
  EXPECT_NEAR(m.moments.x, wall * r * r / 2 + 2 * lid * r * r / 4, 1e-5);
  EXPECT_EQ(m.faces, 3);
  EXPECT_EQ(m.edges, 3);
}

TEST(BrepMeasure, StaysInACopyThatStandsElsewhereAndTellsItsMirrorImage) {
  RunContext context;
  const TopoDS_Shape shape = bracket();
  const auto m = test::brep_form(shape)->measure(context);
  EXPECT_TRUE(m.same(test::brep_form(moved(shape, false))->measure(context)));
  const auto mirror = test::brep_form(moved(shape, true))->measure(context);
  EXPECT_NEAR(mirror.volume, m.volume, 1e-6 * m.volume);
  EXPECT_FALSE(m.same(mirror));
  const Placement half{Mat3(0.5) * burin::rotation({10, 20, 30}), Vec3(9)};
  EXPECT_TRUE(m.scaled(0.5, false).same(test::brep_form(shape, half)->measure(context)));
}

TEST(BrepMeasure, CopiesAreOneItem) {
  Scene scene;
  const auto add = [&](const char* name, std::shared_ptr<const Form> of) {
    Part part;
    part.name = name;
    part.form = std::move(of);
    scene.parts.push_back(std::move(part));
  };
  add("bracket", test::brep_form(bracket()));
  add("bracket #2", test::brep_form(moved(bracket(), false)));
  add("bracket #3", test::brep_form(moved(bracket(), true)));
  add("bracket #4", test::brep_form(bracket()));
  RunContext context;
  Diagnostics said;
  const auto items = find_items(scene, {}, said, context);
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].parts, (std::vector<std::size_t>{0, 1, 3}));
  EXPECT_EQ(items[1].parts, (std::vector<std::size_t>{2}));
}

}  // namespace
}  // namespace burin
