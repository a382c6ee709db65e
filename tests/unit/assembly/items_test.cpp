/// Items: what counts as the same thing, and numbers that stay.

#include <burin/assembly/items.h>
#include <burin/base/placement.h>
#include <burin/forms/mesh/mesh_form.h>
#include <burin/surface/placed_form.h>

#include <burin_test/shapes.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace burin {
namespace {

std::shared_ptr<const Form> form(TriMesh mesh) {
  return std::make_shared<MeshForm>(std::move(mesh));
}

Part part(std::string name, std::shared_ptr<const Form> of) {
  Part p;
  p.name = std::move(name);
  p.source = "a.stl";
  p.form = std::move(of);
  return p;
}

TriMesh turned(TriMesh mesh) {
  const Mat3 turn = rotation({17, -40, 113});
  for (Vec3& p : mesh.positions) p = turn * p + Vec3(300, -20, 7);
  return mesh;
}

/// Other numbers for vertices and triangles.
TriMesh renumbered(TriMesh mesh) {
  const auto n = static_cast<std::uint32_t>(mesh.positions.size());
  std::ranges::reverse(mesh.positions);
  std::ranges::reverse(mesh.triangles);
  for (Triangle& t : mesh.triangles) t = {n - 1 - t[1], n - 1 - t[2], n - 1 - t[0]};
  return mesh;
}

/// A bent arm without a mirror plane: three boxes of different lengths along x, y and z.
TriMesh arm(double hand) {
  const TriMesh m =
      test::joined(test::joined(test::box({0, 0, 0}, {10, 2, 2}), test::box({8, 3, 0}, {10, 9, 2})),
                   test::box({0, 0, 3}, {2, 2, 7}));
  TriMesh out = m;
  for (Vec3& p : out.positions) p.z *= hand;
  if (hand < 0) {
    for (Triangle& t : out.triangles) std::swap(t[1], t[2]);
  }
  return out;
}

std::vector<Item> items_of(const std::vector<Part>& parts, const ItemNumbers& kept = {}) {
  Scene scene;
  scene.parts = parts;
  RunContext context;
  Diagnostics said;
  auto items = find_items(scene, kept, said, context);
  EXPECT_TRUE(said.empty());
  return items;
}

TEST(ShapeMeasure, OfABoxIsThatOfTheFormulas) {
  RunContext context;
  const double a = 4, b = 3, c = 2;
  const ShapeMeasure m = form(test::box({5, 5, 5}, {5 + a, 5 + b, 5 + c}))->measure(context);
  EXPECT_NEAR(m.area, 2 * (a * b + b * c + c * a), 1e-12);
  EXPECT_NEAR(m.volume, a * b * c, 1e-12);
  // Along x: the two ends at a/2, and the four sides of length a.
  const auto along = [](double x, double y, double z) {
    return 2 * y * z * x * x / 4 + 2 * (y + z) * x * x * x / 12;
  };
  EXPECT_NEAR(m.moments.z, along(a, b, c), 1e-10);
  EXPECT_NEAR(m.moments.x, along(c, a, b), 1e-10);
  EXPECT_NEAR(m.handedness, 0, 1e-12);
}

TEST(ShapeMeasure, StaysWhereAShapeIsTurnedAndRenumberedAndTellsMirrorImages) {
  RunContext context;
  const ShapeMeasure m = form(arm(1))->measure(context);
  EXPECT_TRUE(m.same(form(turned(renumbered(arm(1))))->measure(context)));
  const ShapeMeasure mirror = form(arm(-1))->measure(context);
  EXPECT_GT(std::abs(m.handedness), 1e-5);
  EXPECT_NEAR(m.handedness, -mirror.handedness, 1e-9);
  EXPECT_FALSE(m.same(mirror));
  EXPECT_TRUE(m.scaled(1, true).same(mirror));
  const auto doubled = placed(form(arm(1)), {Mat3(2), Vec3(1)})->measure(context);
  EXPECT_TRUE(m.scaled(2, false).same(doubled));
  EXPECT_FALSE(m.same(doubled));
}

TEST(Names, LoseWhatTellsInstancesApart) {
  const std::pair<const char*, const char*> cases[] = {
      {"bolt #2", "bolt"},  {"bolt_1", "bolt"},  {"bolt.002", "bolt"}, {"bolt:3", "bolt"},
      {"bolt (4)", "bolt"}, {"Bolt001", "Bolt"}, {"bolt-12", "bolt"},  {"M6", "M6"},
      {"12", "12"},         {"_7", "_7"},        {"bolt", "bolt"},     {"M6_1 #12", "M6"}};
  for (const auto& [name, stem] : cases) EXPECT_EQ(instance_stem(name), stem) << name;
}

TEST(Items, AreOfOneNameAndOneShape) {
  const auto bolt = form(arm(1));
  const Placer placer(bolt);
  const auto items =
      items_of({part("bolt", bolt), part("plate", form(test::box({0, 0, 0}, {9, 9, 1}))),
                part("bolt_2", placer.at({rotation({90, 0, 0}), Vec3(40)})),
                part("bolt #3", form(turned(renumbered(arm(1))))), part("bolt_4", form(arm(-1))),
                part("nut", form(arm(1)))});
  ASSERT_EQ(items.size(), 4U);
  EXPECT_EQ(items[0].name, "bolt");
  EXPECT_EQ(items[0].parts, (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_EQ(items[1].name, "plate");
  EXPECT_EQ(items[2].name, "bolt_4") << "a mirror image is another thing";
  EXPECT_EQ(items[3].name, "nut");
  for (int i = 0; i < 4; ++i) EXPECT_EQ(items[static_cast<std::size_t>(i)].number, i + 1);
}

TEST(Items, OfOneNameAndSeveralShapesAreTold) {
  const auto items = items_of({part("a", form(test::box({0, 0, 0}, {1, 1, 1}))),
                               part("a", form(test::box({0, 0, 0}, {1, 1, 2}))),
                               part("a", form(test::box({0, 0, 0}, {1, 1, 3})))});
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[1].name, "a (2)");
  EXPECT_EQ(items[2].name, "a (3)");
}

TEST(Items, KeepTheirNumbers) {
  const auto cube = [](double side) { return form(test::box({0, 0, 0}, {side, 1, 1})); };
  const ItemNumbers kept{{2, "b"}, {5, "gone"}, {7, "a"}};
  const auto items = items_of({part("new", cube(1)), part("a", cube(2)), part("b", cube(3))}, kept);
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].number, 2);
  EXPECT_EQ(items[0].name, "b");
  EXPECT_EQ(items[1].number, 7);
  EXPECT_EQ(items[2].number, 8) << "5 stays a hole";
  EXPECT_EQ(numbers_of(items, kept), (ItemNumbers{{2, "b"}, {5, "gone"}, {7, "a"}, {8, "new"}}));
}

TEST(Items, HaveTheColourAndTheFileThatAllOfThemHave) {
  const auto cube = form(test::box({0, 0, 0}, {1, 1, 1}));
  std::vector<Part> parts{part("a", cube), part("a", cube), part("b", cube)};
  parts[0].color = parts[1].color = "#ff0000";
  parts[1].source = "b.stl";
  const auto items = items_of(parts);
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].color, "#ff0000");
  EXPECT_EQ(items[0].source, "");
  EXPECT_EQ(items[1].color, "");
  EXPECT_EQ(items[1].source, "a.stl");
}

}  // namespace
}  // namespace burin
