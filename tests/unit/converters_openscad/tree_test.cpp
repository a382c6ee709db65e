// Trees as OpenSCAD writes them, read.

#include "tree.h"

#include <burin/base/error.h>

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace burin::csg {
namespace {

Tree tree_of(const std::string& text) {
  RunContext context;
  return parse(text, "a.csg", context);
}

/// What is said of a broken text, with its line.
std::string refused(const std::string& text) {
  try {
    tree_of(text);
  } catch (const InputError& e) {
    return std::to_string(e.line()) + ": " + e.what();
  }
  return "nothing";
}

// OpenSCAD of 2025 writes fewer arguments, one number for two, and some of its own.
TEST(CsgTree, TreesOfTodayAreRead) {
  const std::string extruded = "linear_extrude(height = 2, ",
                    rest = "$fn = 0, $fa = 12, $fs = 2) { circle(r = 1); }";
  const auto scale = [&](const std::string& text) {
    return top_scale(tree_of(extruded + text + rest).nodes[1]);
  };
  EXPECT_EQ(scale(""), (std::array{1.0, 1.0}));
  EXPECT_EQ(scale("scale = 0.5, "), (std::array{0.5, 0.5}));
  EXPECT_EQ(scale("scale = [1, 2], "), (std::array{1.0, 2.0}));
  EXPECT_TRUE(is_canonical(tree_of("linear_extrude(height = 2, $fn = 0, $fa = 12, $fs = 2);")));
  EXPECT_FALSE(is_canonical(tree_of("linear_extrude(height = 2);")));
  const auto not_known = [](const std::string& text) { return not_known_in(tree_of(text)); };
  EXPECT_EQ(not_known(extruded + "v = [0, 0, 1], " + rest), "");
  EXPECT_EQ(not_known(extruded + "v = [0.6, 0, 0.8], " + rest), "linear_extrude() along a vector");
  EXPECT_EQ(not_known(extruded + "segments = 9, " + rest), "linear_extrude() in segments");
  EXPECT_EQ(not_known("rotate_extrude(angle = 360, start = 180);"), "");
  EXPECT_EQ(not_known("rotate_extrude(angle = 90, start = 30);"), "");
  EXPECT_EQ(not_known("rotate_extrude(angle = 360, start = 0);"), "rotate_extrude() with a start");
  EXPECT_EQ(not_known("import(file = \"a.dxf\", layer = \"b\");"), "");
  EXPECT_EQ(not_known("import(file = \"a.svg\", layer = \"\");"), "");
  EXPECT_EQ(not_known("import(file = \"a.SVG\", layer = \"b\");"), "import() of a part of a file");
  EXPECT_EQ(not_known("import(file = \"a.svg\", id = \"b\");"), "import() of a part of a file");
}

TEST(CsgTree, NodesKeepTheirOrderAndTheirTexts) {
  const Tree tree = tree_of(
      "group() {\n\tcube(size = [1, 2, 3], center = true);\n\tunion();\n}\n%sphere(r = 2);\n");
  ASSERT_EQ(tree.nodes.size(), 5U);
  EXPECT_EQ(tree.nodes[0].end, 5U);
  EXPECT_EQ(tree.nodes[1].module, Module::Group);
  EXPECT_EQ(tree.nodes[1].end, 4U);
  EXPECT_EQ(tree.text_of(2), "cube(size = [1, 2, 3], center = true);");
  EXPECT_EQ(tree.nodes[2].numbers("size"), (std::vector<double>{1, 2, 3}));
  EXPECT_TRUE(tree.nodes[2].truth("center", false));
  EXPECT_TRUE(tree.nodes[4].background);
  EXPECT_EQ(tree.text_of(4), "sphere(r = 2);");
  EXPECT_EQ(tree.line_of(4), 5);
  std::vector<std::uint32_t> children;
  for_each_child(tree, 0, [&](std::uint32_t c) { children.push_back(c); });
  EXPECT_EQ(children, (std::vector<std::uint32_t>{1, 4}));
}

TEST(CsgTree, TextsEndWhereTheirArgumentDoes) {
  // OpenSCAD 2021.01 does not escape quotes.
  const Tree tree = tree_of("text(text = \"a \"b\", (c) \\\", size = 10, font = \"\");");
  EXPECT_EQ(tree.nodes[1].text("text"), "a \"b\", (c) \\");
  EXPECT_EQ(tree.nodes[1].number("size", 0), 10);
}

TEST(CsgTree, NumbersOfAllKinds) {
  const Tree tree = tree_of("sphere($fn = 1e+06, r = -0.5, x = inf, y = undef);");
  EXPECT_EQ(tree.nodes[1].number("$fn", 0), 1e6);
  EXPECT_EQ(tree.nodes[1].number("r", 0), -0.5);
  EXPECT_EQ(tree.nodes[1].number("y", 7), 7);
  EXPECT_THROW(tree.nodes[1].text("r"), InputError);
}

TEST(CsgTree, MatricesActAsTheyNest) {
  const Tree tree = tree_of(
      "multmatrix([[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]) {\n"
      "multmatrix([[2, 0, 0, 1], [0, 2, 0, 0], [0, 0, 2, 0], [0, 0, 0, 1]]);\n}");
  const Matrix m = matrix_of(tree, 1) * matrix_of(tree, 2);
  EXPECT_EQ((m * std::array<double, 3>{1, 0, 0}), (std::array<double, 3>{5, 3, 0}));
  EXPECT_EQ(m.determinant(), 8);
  EXPECT_EQ(matrix_of(tree, 0), Matrix{});
}

TEST(CsgTree, WhatIsNoTreeIsRefusedWithItsLine) {
  EXPECT_EQ(refused("group() {\ncube(size = 1);\n"), "3: the { of line 1 is never closed");
  EXPECT_EQ(refused("cube();\n}"), "2: a } that closes nothing");
  EXPECT_EQ(refused("\ntranslate([1, 0, 0]) cube();"),
            "2: 'translate' is no module of a tree that OpenSCAD has evaluated");
  EXPECT_EQ(refused("cube(size = [1, 2"), "1: a list that is not closed");
  EXPECT_EQ(refused("text(text = \"a);"), "1: a text that is not closed");
  EXPECT_EQ(refused("cube(size = [[[[[[[[[[1]]]]]]]]]]);"),
            "1: lists in lists in lists without end");
  EXPECT_EQ(refused("cube() cube();"), "1: ; or { expected behind cube()");
  EXPECT_EQ(refused("multmatrix"), "1: ( expected behind multmatrix");
  EXPECT_EQ(refused("/* "), "1: a comment that is not closed");
}

TEST(CsgTree, AMillionNodesAtAnyDepth) {
  constexpr int kMany = 500'000;
  std::string deep, wide;
  for (int i = 0; i < kMany; ++i) deep += "group(){";
  deep.append(kMany, '}');
  for (int i = 0; i < 2 * kMany; ++i) wide += "cube();";
  EXPECT_EQ(tree_of(deep).nodes.size(), kMany + 1U);
  EXPECT_EQ(tree_of(wide).nodes.size(), 2 * kMany + 1U);
}

}  // namespace
}  // namespace burin::csg
