#include <burin/base/error.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

namespace burin {
namespace {

TEST(MeshForm, BoundsInAnyAxes) {
  const MeshForm form(test::box({-1, 0, 2}, {3, 5, 4}));
  const Box3 plain = form.bounds(Mat3(1));
  EXPECT_EQ(plain.min, Vec3(-1, 0, 2));
  EXPECT_EQ(plain.max, Vec3(3, 5, 4));
  // The rows of the matrix are the axes y, z, x; GLM is filled column by column.
  const Box3 turned =
      form.bounds(glm::transpose(Mat3(Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0))));
  EXPECT_EQ(turned.min, Vec3(0, 2, -1));
  EXPECT_EQ(turned.max, Vec3(5, 4, 3));
}

TEST(MeshForm, WithoutCurvatureEveryPointIsUmbilic) {
  RunContext context;
  const auto s = MeshForm(test::torus(3, 1, 40, 20)).realise({.curvature = false}, context);
  const Frame f = s->frame(s->lift({100, {0.2, 0.3, 0.5}}));
  EXPECT_TRUE(f.umbilic);
  EXPECT_EQ(f.confidence, 0);
  EXPECT_NEAR(glm::length(f.normal), 1, 1e-14);
  EXPECT_NEAR(glm::dot(f.normal, f.d1), 0, 1e-14);
  EXPECT_NEAR(glm::dot(f.normal, glm::cross(f.d1, f.d2)), 1, 1e-14);
}

TEST(MeshForm, NamesItsStages) {
  RunContext context;
  MeshForm(test::torus(3, 1, 40, 20)).realise({}, context);
  ASSERT_FALSE(context.stages().empty());
  EXPECT_EQ(context.stages().front().name, "build");
}

TEST(MeshForm, ACancelledRunThrows) {
  RunContext context;
  context.cancel();
  EXPECT_THROW(MeshForm(test::torus(3, 1, 40, 20)).realise({}, context), Cancelled);
}

}  // namespace
}  // namespace burin
