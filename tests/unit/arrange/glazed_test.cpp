// Parts of glass and metal in exploded views.
#include <burin/arrange/arrange.h>
#include <burin/assembly/select.h>
#include <burin/forms/mesh/mesh_form.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <memory>

namespace burin {
namespace {

std::shared_ptr<const Form> form(TriMesh mesh) {
  return std::make_shared<MeshForm>(std::move(mesh));
}

/// A base, and on it a window: a frame with a pane of glass.
Scene window() {
  Scene scene;
  scene.parts.push_back({"base", "a.step", form(test::box({0, 0, 0}, {20, 20, 4}))});
  const TriMesh frame = test::box({0, 0, 4}, {20, 20, 6}), pane = test::box({0, 0, 6}, {20, 20, 7});
  Part part{"window", "a.step", form(test::joined(frame, pane))};
  part.pieces = {{"solid 1", form(frame)}, {"solid 2", form(pane), "#0000ff", 0.3}};
  scene.parts.push_back(std::move(part));
  return scene;
}

Illustration along_z() { return {.explode = {.wanted = true, .along = Vec3(0, 0, 1)}}; }

double lowest(const Part& part) { return part.form->bounds(Mat3(1)).min.z; }

TEST(Glazed, APaneIsOfGlassWhereItsPartHasComeTo) {
  Scene scene = window();
  Illustration plan = along_z();
  RunContext context;
  arrange_parts(scene, plan, context);
  ASSERT_EQ(scene.parts.size(), 3U);
  EXPECT_EQ(path_of(scene.parts[1]), "window/solid 1");
  EXPECT_EQ(path_of(scene.parts[2]), "window/solid 2");
  const auto& styles = plan.illustrate.part_styles;
  ASSERT_EQ(styles.size(), 3U);
  EXPECT_FALSE(styles[0].transparent);
  EXPECT_FALSE(styles[1].transparent);
  EXPECT_TRUE(styles[2].transparent);
  EXPECT_FALSE(styles[2].hatched);
  // They have come apart from the base, not from each other.
  EXPECT_GT(lowest(scene.parts[1]) - lowest(scene.parts[0]), 4.5);
  EXPECT_NEAR(lowest(scene.parts[2]) - lowest(scene.parts[1]), 2, 1e-9);
}

TEST(Glazed, ALookSaysOtherwise) {
  Scene scene = window();
  Illustration plan = along_z();
  plan.looks.push_back({.select = {"window"}, .transparent = false});
  RunContext context;
  arrange_parts(scene, plan, context);
  ASSERT_EQ(scene.parts.size(), 3U);
  EXPECT_FALSE(plan.illustrate.part_styles[2].transparent);
}

}  // namespace
}  // namespace burin
