// Trivariate splines as functions of space.
#include <burin/forms/implicit/implicit_form.h>

#include "reading.h"

#include <cmath>

namespace burin {
namespace {

/// x + 2 y + 4 z over the unit cube.
const std::string kPlane =
    "[OBJECT PLANE [TRIVAR BEZIER 2 2 2 E1 [0] [1] [2] [3] [4] [5] [6] [7]]]\n";

/// (x - 1)^2 + (y - 1)^2 + (z - 1)^2 over [0, 2]^3: quadratic, of three coefficients along x and
/// four along y and z, whose knots hold one at the middle.
std::string bowl() {
  // Control values of (t - 1)^2 by blossoming: (a - 1)(b - 1) of the two knots inside.
  const double along_x[] = {1, -1, 1};  // knots 0 0 0 2 2 2
  const double along[] = {1, 0, 0, 1};  // knots 0 0 0 1 2 2 2
  std::string text =
      "[OBJECT [RGB \"1,2,3\"] BOWL\n[TRIVAR BSPLINE 3 4 4 3 3 3 E1 [KV 0 0 0 2 2 2]\n"
      "[KV 0 0 0 1 2 2 2] [KV 0 0 0 1 2 2 2]\n";
  for (int k = 0; k < 4; ++k) {
    for (int j = 0; j < 4; ++j) {
      for (int i = 0; i < 3; ++i) {
        text += fmt::format("[{}] ", along_x[i] + along[j] + along[k]);
      }
    }
  }
  return text + "]]\n";
}

TEST(IritTrivariate, StandsInTheTree) {
  const IritObject root = test::tree_of(kPlane);
  const auto& item = std::get<IritTrivariate>(root.objects.at(0).items.at(0));
  EXPECT_EQ(item.spline.size, (std::array<std::int32_t, 3>{2, 2, 2}));
  EXPECT_EQ(item.spline.order, (std::array<std::int32_t, 3>{2, 2, 2}));
  EXPECT_EQ(item.spline.knots[2], (std::vector<double>{0, 0, 1, 1}));
  EXPECT_EQ(item.spline.coefficients, (std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(item.line, 1);
}

TEST(IritTrivariate, ABallOfItsLevel) {
  const test::TempFile file("a.itd", bowl());
  RunContext context;
  IritReadOptions options;
  options.level = 0.25;
  const Scene scene = read_irit(file.path(), context, options);
  ASSERT_EQ(scene.parts.size(), 1u);
  EXPECT_EQ(scene.parts[0].name, "BOWL");
  EXPECT_EQ(scene.parts[0].color, "#010203");
  EXPECT_TRUE(scene.diagnostics.empty());
  const Box3 box = scene.parts[0].form->bounds(Mat3(1));
  test::expect_near(box.min, Vec3(0.5), 1e-2);
  test::expect_near(box.max, Vec3(1.5), 1e-2);
  RealiseOptions realise;
  realise.tolerance = 1e-3;
  const auto surface = scene.parts[0].form->realise(realise, context);
  for (const Vec3& p : surface->proxy().mesh.positions) {
    EXPECT_NEAR(glm::distance(p, Vec3(1)), 0.5, 1e-9);
  }
  const FileInfo info = inspect_irit(file.path(), context, options);
  EXPECT_NEAR(info.parts.at(0).volume, std::acos(-1.0) / 6, 1e-3);
  EXPECT_FALSE(info.parts.at(0).triangles.has_value());
  // The cube around the ball.
  options.inside_above = true;
  EXPECT_NEAR(inspect_irit(file.path(), context, options).parts.at(0).volume,
              8 - std::acos(-1.0) / 6, 1e-2);
}

TEST(IritTrivariate, AnInstanceIsStretched) {
  // Points are rows to the left of the matrix: x doubled, z slanted over x and mirrored, moved.
  const test::TempFile file(
      "a.itd", bowl() + "[OBJECT B [INSTANCE BOWL 2 0 0 0  0 1 0 0  0.5 0 -1 0  10 0 0 1]]\n");
  RunContext context;
  IritReadOptions options;
  options.level = 0.25;
  const Scene scene = read_irit(file.path(), context, options);
  ASSERT_EQ(scene.parts.size(), 2u);
  EXPECT_TRUE(scene.diagnostics.empty());
  const auto surface = scene.parts[1].form->realise({.tolerance = 1e-3}, context);
  for (const Vec3& p : surface->proxy().mesh.positions) {
    const Vec3 back((p.x - 10 + 0.5 * p.z) / 2, p.y, -p.z);
    EXPECT_NEAR(glm::distance(back, Vec3(1)), 0.5, 1e-9);
  }
  const FileInfo info = inspect_irit(file.path(), context, options);
  EXPECT_NEAR(info.parts.at(1).volume, 2 * std::acos(-1.0) / 6, 2e-3);
  EXPECT_FALSE(info.parts.at(1).triangles.has_value());
}

TEST(IritTrivariate, Errors) {
  test::expect_error("\n" + kPlane, 2, "level");
  test::expect_error("[OBJECT A [TRIVAR BEZIER 2 2 2 E1 [0] [1] [2]]]", 1, "8 control points");
  test::expect_error("[OBJECT A [TRIVAR BEZIER 2 2 2 E1 [0] [1] [2] [3] [4] [5] [6] [nan]]]", 1,
                     "no finite number");
  test::expect_error(
      "[OBJECT A [TRIVAR BEZIER 2 2 2 P1 [1 0] [1 1] [1 2] [1 3] [1 4] [1 5] [1 6] "
      "[1 7]]]",
      1, "1 TRIVAR of points P1 (trivariate volume)");
}

}  // namespace
}  // namespace burin
