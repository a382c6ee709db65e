#include "balance.h"
#include "csg_worked.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace burin::csg::test {
namespace {

/// A ball of 2,460 triangles, drilled.
std::string drilled_ball() {
  return "difference() { " + sphere(5, 50) + cylinder(30, 2, 2, 32) + "}";
}

std::string beside_each_other(int n) {
  std::string text;
  for (int i = 0; i < n; ++i) text += moved(20 * i, 0, 0, turned(7 * i, drilled_ball()));
  return text;
}

TEST(Alike, ManyAreCutOnceAndStandWhereTheyShould) {
  constexpr int kCount = 30;
  const Worked one = work_out(drilled_ball()), all = work_out(beside_each_other(kCount));
  EXPECT_EQ(one.cuts, 1u);
  EXPECT_EQ(all.cuts, 1u);
  EXPECT_NEAR(volume(all.solid), kCount * volume(one.solid), 1e-11 * volume(all.solid));
  EXPECT_EQ(all.solid.triangles.size(), kCount * one.solid.triangles.size());
  EXPECT_EQ(open_edges(all.solid), 0u);
  // Each has surfaces of its own, about its own axis.
  for (std::size_t t = 0; t < all.solid.triangles.size(); ++t) {
    if (all.solid.surface[t] < 0) continue;
    const Turned& s = all.solid.surfaces[static_cast<std::size_t>(all.solid.surface[t])];
    const double x = all.solid.positions[all.solid.triangles[t][0]].x;
    EXPECT_LT(std::abs(s.origin.x - x), 5.001);
  }
}

TEST(Alike, MirroredOnesLookOutwards) {
  std::string text;
  for (int i = 0; i < 30; ++i) {
    text += moved(20 * i, 0, 0, scaled(i % 2 == 0 ? 1 : -1, 1, 1, drilled_ball()));
  }
  const Worked all = work_out(text);
  EXPECT_EQ(all.cuts, 1u);
  EXPECT_NEAR(volume(all.solid), 30 * volume(work_out(drilled_ball()).solid), 1e-8);
  EXPECT_EQ(open_edges(all.solid), 0u);
}

TEST(Alike, GroupsOfOneUnionAreToldFromEachOther) {
  // Two of one union: in each a drilled ball apart from a cube that meets a ball.
  const std::string pair = "union() { " + drilled_ball() + moved(0, 20, 0, sphere(5, 50)) +
                           moved(2, 20, 0, cube(9, 1, 1)) + "}";
  std::string text;
  for (int i = 0; i < 12; ++i) text += moved(20 * i, 0, 0, pair);
  const Worked all = work_out(text);
  EXPECT_EQ(all.cuts, 2u);
  EXPECT_NEAR(volume(all.solid), 12 * volume(work_out(pair).solid), 1e-8);
}

TEST(Alike, FewAreCutWhereTheyStand) { EXPECT_EQ(work_out(beside_each_other(3)).cuts, 3u); }

TEST(Balanced, NoUnionHasMoreThanAFewChildren) {
  Formula row;
  row.nodes.push_back({Formula::Kind::Union, 0, {}});
  std::vector<Mesh> meshes;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    row.nodes.push_back({Formula::Kind::Mesh, i, {}});
    row.nodes[0].children.push_back(i + 1);
    Mesh mesh;
    mesh.box.add(Vec3((i * 37) % 1000, 0, 0));
    mesh.box.add(Vec3((i * 37) % 1000 + 1, 1, 1));
    meshes.push_back(mesh);
  }
  const Formula tree = balanced(row, boxes_of(row, meshes));
  const std::vector<Box3> box = boxes_of(tree, meshes);
  std::vector<std::uint32_t> found;
  std::size_t asked = 0;
  const Vec3 place(500.5, 0.5, 0.5);
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const Formula::Node& n = tree.nodes[open.back()];
    open.pop_back();
    EXPECT_LE(n.children.size(), 4u);
    for (const std::uint32_t c : n.children) {
      ++asked;
      if (!box[c].contains(place)) continue;
      if (tree.nodes[c].kind == Formula::Kind::Mesh) found.push_back(tree.nodes[c].mesh);
      open.push_back(c);
    }
  }
  EXPECT_EQ(found, std::vector<std::uint32_t>{(500u * 973u) % 1000u});
  EXPECT_LT(asked, 40u);
  EXPECT_EQ(std::ranges::count(tree.nodes, Formula::Kind::Mesh, &Formula::Node::kind), 1000);
}

}  // namespace
}  // namespace burin::csg::test
