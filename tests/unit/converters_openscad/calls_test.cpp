// Calls of modules: how a program is marked, and what is read from its tree.

#include "calls.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace burin::detail {
namespace {

using Names = std::vector<std::string>;

Names marked(std::string_view program) {
  const auto found = mark_calls(program);
  Names out;
  if (!found) return out;
  for (const ModuleCall& c : found->calls) {
    out.push_back((c.in_module ? "in " : "") + c.module + (c.name == c.module ? "" : "=" + c.name));
  }
  return out;
}

TEST(ModuleCalls, AreThoseOfModulesThatAreNotOpenscads) {
  EXPECT_EQ(
      marked("module a() { cube(1); b(); }\nmodule b() sphere(1);\na(); translate([1,2]) #a();"),
      (Names{"in b", "a", "a"}));
  EXPECT_EQ(marked("cube(1); for (i = [0:3]) { rotate(i) cube(2); }"), Names{});
  EXPECT_EQ(marked("if (x) a(); else { b(); }\nlet (y = 2) c(y);"), (Names{"a", "b", "c"}));
  EXPECT_EQ(marked("x = 3; function f(a) = a; include <l.scad>\nuse <k.scad>\necho(\"a();\") /* "
                   "c(); */ b(); // d();"),
            Names{"b"});
}

TEST(ModuleCalls, ChainsAreCalledByTheirInnermost) {
  EXPECT_EQ(marked("row(3) turn() bolt();"), (Names{"bolt", "turn=bolt", "row=bolt"}));
  EXPECT_EQ(marked("row(3) translate([1, 0, 0]) { bolt(); nut(); }"),
            (Names{"bolt", "nut", "row"}));
}

TEST(ModuleCalls, BelowWhatMakesOneThingAreNotMarked) {
  EXPECT_EQ(
      marked("difference() { a(); b(); } hull() a(); union() { a(); } linear_extrude(2) a();"),
      Names{});
  EXPECT_EQ(marked("module m() { minkowski() { a(); b(); } } m();"), Names{"m"});
}

TEST(ModuleCalls, TextsThatAreNotUnderstoodAreNotMarked) {
  for (const char* text : {"", "a(", "a() {", "}", "module polyhedron() cube(1); a();", "a() b;",
                           "module group() children(); a();", "a();;;; }"}) {
    EXPECT_FALSE(mark_calls(text)) << text;
  }
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "a() ";
  EXPECT_FALSE(mark_calls(deep + ";"));
}

TEST(ModuleCalls, LinesKeepTheirNumbers) {
  const std::string program = "a(\n1);\n\nif (x)\n  b();\nelse c();\n";
  const auto found = mark_calls(program);
  ASSERT_TRUE(found);
  EXPECT_EQ(std::ranges::count(found->text, '\n'), std::ranges::count(program, '\n'));
  EXPECT_NE(found->text.find("else group(){polyhedron("), std::string::npos) << found->text;
}

TEST(ModuleCalls, MarksAreTakenOutOfTheTree) {
  const std::string mark =
      "polyhedron(points = [[0.161803, 0.577216, 0.693147], [100001, 0, 0]], faces = [], convexity "
      "= 1);";
  RunContext context;
  csg::Tree tree = csg::parse(
      "cube();\ngroup() {\n" + mark + "\n\tgroup() {\n\t\tsphere();\n\t}\n}\ncylinder();\n", "a",
      context);
  const TreeCalls calls = take_calls(tree, {{"a", "a", false}, {"bolt", "row", true}});
  ASSERT_EQ(tree.nodes.size(), 6U);
  EXPECT_EQ(calls.at(1), nullptr);
  ASSERT_NE(calls.at(2), nullptr);
  EXPECT_EQ(calls.at(2)->name, "bolt");
  EXPECT_EQ(tree.text_of(3), "group() {\n\t\tsphere();\n\t}");
  EXPECT_EQ(tree.nodes[2].end, 5U);
  EXPECT_EQ(tree.nodes[0].end, 6U);
  EXPECT_EQ(tree.source.find("polyhedron"), std::string::npos);
  // What says another number is no mark.
  csg::Tree other = csg::parse("group() { " + mark + " }", "a", context);
  EXPECT_EQ(take_calls(other, {{"a", "a", false}}).at(1), nullptr);
  EXPECT_EQ(other.nodes.size(), 3U);
}

}  // namespace
}  // namespace burin::detail
