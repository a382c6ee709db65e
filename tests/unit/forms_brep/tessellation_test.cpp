#include <burin/base/error.h>

#include "brep_checks.h"

#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <gtest/gtest.h>

#include <numbers>

namespace burin::test {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

struct Case {
  std::string name;
  TopoDS_Shape shape;
  double area, volume;
  int euler, sharp, smooth, seams;
};

std::vector<Case> cases() {
  const double slant = std::sqrt(2.0 * 2.0 + 3.0 * 3.0);
  const double r = 0.25;  // of the filleted box of 4 x 3 x 2
  const double a = 4 - 2 * r, b = 3 - 2 * r, c = 2 - 2 * r;
  return {
      {"Box", box_shape(1, 2, 3), 22, 6, 2, 12, 0, 0},
      {"Cylinder", cylinder_shape(2, 5), 28 * kHalfTurn, 20 * kHalfTurn, 2, 2, 0, 1},
      {"ConeWithTip", BRepPrimAPI_MakeCone(2, 0, 3).Shape(), kHalfTurn * 2 * (2 + slant),
       4 * kHalfTurn, 2, 1, 0, 1},
      {"ConeTipBelow", BRepPrimAPI_MakeCone(0, 2, 3).Shape(), kHalfTurn * 2 * (2 + slant),
       4 * kHalfTurn, 2, 1, 0, 1},
      {"Sphere", BRepPrimAPI_MakeSphere(3).Shape(), 36 * kHalfTurn, 36 * kHalfTurn, 2, 0, 0, 1},
      {"Torus", BRepPrimAPI_MakeTorus(3, 1).Shape(), 12 * kHalfTurn * kHalfTurn,
       6 * kHalfTurn * kHalfTurn, 0, 0, 0, 2},
      {"FilletedBox", filleted_box_shape(r),
       2 * (a * b + b * c + c * a) + 2 * kHalfTurn * r * (a + b + c) + 4 * kHalfTurn * r * r,
       a * b * c + 2 * r * (a * b + b * c + c * a) + kHalfTurn * r * r * (a + b + c) +
           4 * kHalfTurn * r * r * r / 3,
       2, 0, 48, 0},
      {"PlateWithHole", plate_with_hole_shape(), 196 - 8 * kHalfTurn + 4 * kHalfTurn,
       80 - 4 * kHalfTurn, 0, 14, 0, 1},
  };
}

TEST(BrepTessellation, AnalyticShapes) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const ModelPtr model = make_brep_model(c.shape);
    RunContext context;
    for (const double share : {1e-2, 2e-3, 2e-4}) {
      const double tolerance = share * model->size();
      const auto mesh = model->tessellate(tolerance, context, nullptr);
      EXPECT_EQ(defects(*model, *mesh), "");
      EXPECT_EQ(open_half_edges(*mesh), 0);
      EXPECT_EQ(euler_characteristic(*mesh), c.euler);
      // Off the surface by `tolerance`; along it, where nothing shows, by up to four times that.
      EXPECT_LE(mesh->tolerance, 4.01 * tolerance);
      // A chord that is off by h shortens by a share of h, and the solid by a layer of h.
      EXPECT_NEAR(area(*mesh), c.area, 10 * share * c.area);
      EXPECT_NEAR(volume(*mesh), c.volume, c.area * tolerance);
      EXPECT_EQ(count_edges(*mesh, ModelEdgeClass::Sharp), c.sharp);
      EXPECT_EQ(count_edges(*mesh, ModelEdgeClass::Smooth), c.smooth);
      EXPECT_EQ(count_edges(*mesh, ModelEdgeClass::Seam), c.seams);
    }
  }
}

}  // namespace
}  // namespace burin::test
