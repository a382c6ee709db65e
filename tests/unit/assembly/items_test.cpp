/// Items: what counts as the same thing, and numbers that stay.

#include <burin/assembly/items.h>
#include <burin/assembly/select.h>
#include <burin/assembly/things.h>
#include <burin/base/error.h>
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

/// A square bar, twisted by a third of a turn: chiral, though the middles of body and surface are
/// one.
TriMesh twisted_bar() {
  constexpr int kSlices = 12;
  TriMesh m;
  for (int i = 0; i <= kSlices; ++i) {
    const double z = 20.0 * i / kSlices - 10, turn = z / 20 * 2 * std::numbers::pi / 3;
    for (int k = 0; k < 4; ++k) {
      const double a = turn + k * std::numbers::pi / 2;
      m.positions.emplace_back(3 * std::cos(a), 3 * std::sin(a), z);
    }
  }
  const auto at = [](int slice, int k) { return static_cast<std::uint32_t>(4 * slice + k % 4); };
  for (int i = 0; i < kSlices; ++i) {
    for (int k = 0; k < 4; ++k) {
      m.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      m.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  }
  for (const auto& [slice, sense] : {std::pair(0, -1), std::pair(kSlices, 1)}) {
    m.triangles.push_back({at(slice, 0), at(slice, 2 - sense), at(slice, 2)});
    m.triangles.push_back({at(slice, 0), at(slice, 2), at(slice, 2 + sense)});
  }
  return m;
}

TriMesh mirrored(TriMesh mesh) {
  for (Vec3& p : mesh.positions) p.y = -p.y;
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// Names and quantities.
using List = std::vector<std::pair<std::string, std::size_t>>;
List list_of(const std::vector<Item>& items) {
  List list;
  for (const Item& item : items) list.emplace_back(item.name, item.parts.size());
  return list;
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

// A legend says "arm (2)", which selects what it stands beside.
TEST(Items, AreSelectedByTheNamesThatListsHave) {
  Scene scene;
  scene.parts = {part("arm1", form(arm(1))), part("arm2", form(arm(-1))),
                 part("arm3", form(arm(-1))), part("left", form(test::box({0, 0, 0}, {1, 2, 3})))};
  for (std::size_t i = 0; i < 3; ++i) scene.parts[i].definition = "arm";
  scene.parts[3].definition = "screw M6";
  RunContext context;
  Diagnostics said;
  for (const Item& item : find_items(scene, {}, said, context)) {
    EXPECT_EQ(select(scene, item.name), item.parts) << item.name;
  }
  EXPECT_EQ(select(scene, "arm (2)"), (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(select(scene, "screw*"), (std::vector<std::size_t>{3}));
  EXPECT_THROW(select(scene, "arm (3)"), UsageError);
  scene.parts[3].name = "arm (2)";
  EXPECT_EQ(select(scene, "arm (2)"), (std::vector<std::size_t>{3})) << "names of parts go first";
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

TEST(Items, AreOneWhereNamesDifferByANumberAtTheEnd) {
  const auto items = items_of({part("chip", form(arm(1))), part("chip2", form(turned(arm(1)))),
                               part("chip3", form(arm(1))), part("chips", form(arm(1))),
                               part("Wheel 1", form(test::box({0, 0, 0}, {1, 1, 1}))),
                               part("Wheel 2", form(test::box({3, 0, 0}, {4, 1, 1})))});
  EXPECT_EQ(list_of(items), (List{{"chip", 3}, {"chips", 1}, {"Wheel", 2}}));
}

TEST(Items, ThatAreInstancesCountByWhatTheyAreInstancesOf) {
  const auto foot = form(arm(1));
  std::vector<Part> parts{part("left", foot), part("right", foot), part("left", foot)};
  parts[0].definition = parts[1].definition = "foot";
  EXPECT_EQ(list_of(items_of(parts)), (List{{"foot", 2}, {"left", 1}}));
}

// The row of two products was called as their instances were: "Occurrence", "$3".
TEST(Items, AreCalledAsWhatTheyAreInstancesOfWhereTheseDifferByANumber) {
  const auto block = form(test::box({0, 0, 0}, {1, 2, 3}));
  std::vector<Part> parts{part("Occurrence", block), part("Occurrence #2", block),
                          part("$3", block)};
  for (std::size_t i = 0; i < 3; ++i) parts[i].definition = "Spacer " + std::to_string(i + 1);
  EXPECT_EQ(list_of(items_of(parts)), (List{{"Spacer", 3}}));
  for (std::size_t i = 0; i < 3; ++i) parts[i].definition = "M" + std::to_string(i + 6);
  EXPECT_EQ(list_of(items_of(parts)), (List{{"M6", 3}}));
}

TEST(Items, CountPartsThatAreOneThingOnce) {
  const auto body = form(test::box({0, 0, 0}, {9, 9, 30}));
  const auto thing = [&](const Placement& place, double shaft) {
    std::vector<Part> parts{
        part("#c0c0c0", placed(body, place)),
        part("#ffd700", placed(form(test::box({shaft, 0, 30}, {shaft + 2, 3, 40})), place))};
    for (Part& p : parts) p.assembly = {"motor"}, p.definition = "motor";
    parts[1].joined = true;
    return parts;
  };
  Scene scene;
  const auto add = [&](const std::vector<Part>& parts) {
    scene.parts.insert(scene.parts.end(), parts.begin(), parts.end());
  };
  add(thing({}, 1));
  add(thing({rotation({0, 0, 90}), Vec3(50, 0, 0)}, 1));
  add(thing({Mat3(1), Vec3(90, 0, 0)}, 5));
  EXPECT_EQ(things_of(scene), (std::vector<std::size_t>{0, 0, 2, 2, 4, 4}));
  const auto items = items_of(scene.parts);
  ASSERT_EQ(items.size(), 2U) << "a shaft elsewhere makes another motor";
  EXPECT_EQ(items[0].parts, (std::vector<std::size_t>{0, 1, 2, 3}));
  EXPECT_EQ(items[1].parts, (std::vector<std::size_t>{4, 5}));
  scene.parts[2].assembly = scene.parts[3].assembly = {"motor #2"};
  scene.parts[4].assembly = scene.parts[5].assembly = {"motor"};
  EXPECT_EQ(selectors_of(scene), (std::vector<std::string>{"@index=0", "@index=0", "/motor #2",
                                                           "/motor #2", "@index=4", "@index=4"}));
}

TEST(Items, JoinAShapeThatIsItsOwnMirrorImageWithItsImages) {
  const auto wedge = [] {
    return test::joined(test::box({0, 0, 0}, {10, 2, 2}), test::box({0, 0, 2}, {2, 2, 9}));
  };
  const auto items =
      items_of({part("wedge", form(wedge())), part("wedge", form(turned(mirrored(wedge())))),
                part("ball", form(test::ellipsoid(Vec3(5), 24, 12))),
                part("ball", form(turned(mirrored(test::ellipsoid(Vec3(5), 24, 12)))))});
  EXPECT_EQ(list_of(items), (List{{"wedge", 2}, {"ball", 2}}));
}

TEST(Items, KeepLeftAndRightApartWhereNoMomentTellsThem) {
  RunContext context;
  EXPECT_FALSE(form(twisted_bar())->measure(context).handed());
  const auto items =
      items_of({part("bar", form(twisted_bar())), part("bar", form(mirrored(twisted_bar()))),
                part("bar", form(turned(twisted_bar()))),
                part("bar", form(turned(mirrored(twisted_bar()))))});
  ASSERT_EQ(list_of(items), (List{{"bar", 2}, {"bar (2)", 2}}));
  EXPECT_EQ(items[0].parts, (std::vector<std::size_t>{0, 2}));
}

TEST(Items, AreRenamedByTheNumberOfTheirRow) {
  const auto cube = [](double side) { return form(test::box({0, 0, 0}, {side, 1, 1})); };
  const std::vector<Part> parts{part("plate", cube(1)), part("bolt", cube(2)), part("nut", cube(3)),
                                part("bolt", cube(2))};
  Scene scene;
  scene.parts = parts;
  RunContext context;
  Diagnostics said;
  const auto items = find_items(scene, {{2, {"Hex screw", {}, true}}}, said, context);
  EXPECT_EQ(list_of(items), (List{{"plate", 1}, {"Hex screw", 2}, {"nut", 1}}));
  for (int i = 0; i < 3; ++i) EXPECT_EQ(items[static_cast<std::size_t>(i)].number, i + 1);
  ASSERT_EQ(said.entries().size(), 1U);
  EXPECT_EQ(said.entries()[0].code, "items.renamed");
  // What only remembers a name renames nothing.
  EXPECT_EQ(list_of(items_of(parts, {{2, {"gone"}}})),
            (List{{"plate", 1}, {"bolt", 2}, {"nut", 1}}));
}

TEST(Items, AreRenamedByASelectorWhereverTheyStand) {
  const auto cube = [](double side) { return form(test::box({0, 0, 0}, {side, 1, 1})); };
  const std::vector<Part> parts{part("new", cube(4)), part("plate", cube(1)), part("bolt", cube(2)),
                                part("bolt_2", cube(2))};
  const auto items = items_of(parts, {{1, {"Platte", "plate"}}, {2, {"Schraube", "bolt*"}}});
  EXPECT_EQ(list_of(items), (List{{"Platte", 1}, {"Schraube", 2}, {"new", 1}}));
  EXPECT_EQ(items[2].number, 3);
  EXPECT_THROW(items_of(parts, {{1, {"both", "*"}}}), UsageError);
}

TEST(Items, CopiesWithNumbersOfTheirOwnAreItemsOfTheirOwn) {
  const auto bolt = form(test::box({0, 0, 0}, {2, 1, 1}));
  const std::vector<Part> parts{part("bolt", bolt), part("bolt #2", bolt), part("bolt #3", bolt)};
  const auto items = items_of(parts, {{6, {"", "/bolt"}}, {7, {"", "/bolt #2"}}});
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].number, 6);
  EXPECT_EQ(items[0].parts, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(items[1].number, 7);
  EXPECT_EQ(items[1].name, "bolt (2)");
  EXPECT_EQ(items[1].parts, std::vector<std::size_t>{1});
  EXPECT_THROW(items_of(parts, {{6, {"", "/bolt"}}, {7, {"", "/bolt"}}}), UsageError);
}

TEST(Items, WhatIsNotListedHasNoNumber) {
  Scene scene;
  scene.parts = {part("a", form(test::box({0, 0, 0}, {1, 1, 1}))),
                 part("b", form(test::box({0, 0, 0}, {2, 1, 1}))),
                 part("c", form(test::box({0, 0, 0}, {3, 1, 1})))};
  RunContext context;
  Diagnostics said;
  const auto items = find_items(scene, {}, said, context, {false, true});
  EXPECT_EQ(list_of(items), (List{{"a", 1}, {"c", 1}}));
  EXPECT_EQ(items[1].number, 2);
}

TEST(Selectors, OfPartsChooseThemAlone) {
  Scene scene;
  const auto cube = form(test::box({0, 0, 0}, {1, 1, 1}));
  for (const char* name : {"a/b", "a", "c;d", "e*"}) scene.parts.push_back(part(name, cube));
  scene.parts.push_back(part("a", cube));
  scene.parts.back().assembly = {"top"};
  for (int i = 0; i < 2; ++i) scene.parts.push_back(part("twice", cube));
  const std::vector<std::string> selectors = selectors_of(scene);
  EXPECT_EQ(selectors[4], "/top/a");
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    EXPECT_EQ(select(scene, selectors[i]), std::vector<std::size_t>{i}) << selectors[i];
  }
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
  const ItemNumbers kept{{2, {"b"}}, {5, {"gone"}}, {7, {"a"}}};
  const auto items = items_of({part("new", cube(1)), part("a", cube(2)), part("b", cube(3))}, kept);
  ASSERT_EQ(items.size(), 3U);
  EXPECT_EQ(items[0].number, 2);
  EXPECT_EQ(items[0].name, "b");
  EXPECT_EQ(items[1].number, 7);
  EXPECT_EQ(items[2].number, 8) << "5 stays a hole";
  EXPECT_EQ(numbers_of(items, kept),
            (ItemNumbers{{2, {"b"}}, {5, {"gone"}}, {7, {"a"}}, {8, {"new"}}}));
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
