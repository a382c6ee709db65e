// Parts of trees, and what burin.scad says of them.

#include "parts.h"

#include <burin/base/error.h>

#include "marks.h"
#include "model_marks.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace burin::detail {
namespace {

struct Found {
  csg::Tree tree;
  TreeParts parts;
  Diagnostics diagnostics;
  ModelMarks marks;

  explicit Found(const std::string& text, std::string_view program = "") {
    RunContext context;
    tree = csg::parse(text, "a.csg", context);
    parts = parts_of(tree, program, "a", diagnostics);
    marks = asked(std::vector<bool>(parts.parts.size(), true));
  }
  /// What is asked of the drawing where something came of these parts.
  ModelMarks asked(const std::vector<bool>& made) { return marks_of(parts, made, diagnostics); }
  std::vector<std::string> names() const {
    std::vector<std::string> out;
    for (const TreePart& p : parts.parts) out.push_back(p.name);
    return out;
  }
  std::string text(std::size_t part, std::size_t piece = 0) const {
    return std::string(tree.text_of(parts.parts[part].pieces[piece].node));
  }
};

using Names = std::vector<std::string>;

std::string point(double a, double b) {
  return "[" + std::to_string(a) + ", " + std::to_string(b) + ", 0], ";
}
std::string said(const std::string& text) {
  std::string out = point(3, static_cast<double>(text.size()));
  for (const char c : text) out += point(c, 0);
  return out;
}
std::string said(double number) { return point(2, number); }

/// A call of burin.scad as it stands in a tree.
std::string call(const std::string& what, const std::string& arguments, int count,
                 const std::string& children) {
  return "group() { group() { polyhedron(points = [[0.271828, 0.314159, 0.141421], " +
         point(4, count + 1) + said(what) + arguments + "], faces = [], convexity = 1); } " +
         (children.empty() ? "" : "group() { " + children + " }") + " }\n";
}

const std::string kMoved = "multmatrix([[1,0,0,9],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) ";

TEST(TreeParts, ObjectsAtTheTopAreParts) {
  const Found found(kMoved + "{ group() { cube(); sphere(); } }\ngroup() { cube(); sphere(); }\n",
                    "translate([9, 0, 0]) arm(); arm();");
  EXPECT_EQ(found.names(), (Names{"arm", "arm #2"}));
  // Where one stands is parted from what it is, so that equal ones are told to be.
  EXPECT_EQ(found.text(0), found.text(1));
  EXPECT_EQ(found.parts.parts[0].pieces[0].at.row[0][3], 9);
  EXPECT_TRUE(found.marks.empty());
}

TEST(TreeParts, WordsOfBurinScadAreNoNames) {
  const std::string mark = call("callout", "", 0, "cube();");
  EXPECT_EQ(Found(mark, "callout() cube();").names(), Names{"a"});
  EXPECT_EQ(Found(mark, "callout() arm();").names(), Names{"arm"});
  EXPECT_EQ(Found(call("ink", said("outline"), 1, "cube();"), "ink(\"outline\") cube();").names(),
            Names{"a"});
  // A module that has the name, and says nothing.
  EXPECT_EQ(Found("group() { cube(); }", "callout();").names(), Names{"callout"});
}

TEST(TreeParts, WhatIsWrongManyTimesIsSaidOnce) {
  const Found found(call("part", said(""), 1, "cube();") + call("part", said(""), 1, "sphere();"));
  ASSERT_EQ(found.diagnostics.entries().size(), 1U);
  EXPECT_EQ(found.diagnostics.entries()[0].count, 2);
}

TEST(TreeParts, WhatOnlyShowsSomethingIsNoItem) {
  const Found found("cube(); %sphere(); #sphere(); difference() { cube(); #cylinder(); }");
  std::map<std::string, bool> listed;
  for (const ModelMarks::Look& look : found.marks.looks) listed[look.part] = look.listed;
  EXPECT_EQ(listed, (std::map<std::string, bool>{{"/a (background)", false},
                                                 {"/a (highlighted)", true},
                                                 {"/a (highlighted) #2", false}}));
}

TEST(TreeParts, AThreadIsOnTheWholeOfThePartThatHoldsItsChildren) {
  const std::string shaft = call("thread", said("M6") + said(18.0), 2, "cylinder(h = 20);");
  const Found found(call("part", said("screw"), 1, "sphere(); " + shaft));
  ASSERT_EQ(found.names(), Names{"screw"});
  EXPECT_EQ(found.parts.parts[0].pieces.size(), 2U);
  ASSERT_EQ(found.marks.threads.size(), 1U);
  EXPECT_EQ(found.marks.threads[0].part, "/screw");
  EXPECT_EQ(found.marks.threads[0].size, "M6");
  EXPECT_EQ(found.marks.threads[0].length, 18);
  const Found around(call("thread", said("M6x0.75"), 1, call("part", said("nut"), 1, "cube();")));
  ASSERT_EQ(around.marks.threads.size(), 1U);
  EXPECT_EQ(around.marks.threads[0].part, "/nut");
  EXPECT_FALSE(around.marks.threads[0].length);
  const Found wrong(call("thread", said(6.0), 1, "cylinder(h = 20);"));
  EXPECT_TRUE(wrong.marks.threads.empty());
  ASSERT_EQ(wrong.diagnostics.entries().size(), 1U);
  EXPECT_NE(wrong.diagnostics.entries()[0].message.find("thread() takes"), std::string::npos);
}

TEST(TreeParts, ObjectsWithoutANameHaveThatOfTheFile) {
  EXPECT_EQ(Found("cube();").names(), Names{"a"});
  EXPECT_EQ(Found("cube(); sphere();").names(), (Names{"a", "a #2"}));
  EXPECT_EQ(Found("group();\ngroup() { group(); }").names(), Names{});
}

TEST(TreeParts, ColoursPartWhatIsShownAsItIs) {
  const Found found(
      "group() { color([1, 0, 0, 1]) { cube(); color([0, 1, 0, 1]) { cube(); } }\n"
      "color([1, 0, 0, 1]) { sphere(); } cylinder(); }");
  ASSERT_EQ(found.parts.parts.size(), 2U);
  EXPECT_EQ(found.parts.parts[0].color, "#ff0000");
  EXPECT_EQ(found.parts.parts[0].pieces.size(), 2U);  // the outermost colour holds
  EXPECT_EQ(found.parts.parts[1].color, "");
  // Not within what makes one thing of its children.
  const Found one(
      "difference() { color([0, 0, 1, 1]) { cube(); } color([1, 0, 0, 1]) { sphere(); } }");
  ASSERT_EQ(one.parts.parts.size(), 1U);
  EXPECT_EQ(one.parts.parts[0].color, "#0000ff");
}

TEST(TreeParts, ModifiersShowThingsOfTheirOwn) {
  const Found found("%cube(size = 1);\ndifference() { cube(size = 2); " + kMoved +
                    "{ #cylinder(h = 3); } }");
  EXPECT_EQ(found.names(), (Names{"a (background)", "a", "a (highlighted)"}));
  EXPECT_EQ(found.text(2), "cylinder(h = 3);");
  EXPECT_EQ(found.parts.parts[2].pieces[0].at.row[0][3], 9);
  ASSERT_EQ(found.marks.looks.size(), 2U);
  EXPECT_EQ(found.marks.looks[0].part, "/a (background)");
  EXPECT_TRUE(found.marks.looks[0].transparent);
  EXPECT_FALSE(found.marks.looks[0].hatched);
  // What is rooted is alone, and where its parents would not move it.
  const Found rooted("cube(); " + kMoved + "{ !sphere(); }");
  ASSERT_EQ(rooted.names(), Names{"a"});
  EXPECT_EQ(rooted.parts.parts[0].pieces[0].at, csg::Matrix{});
}

TEST(TreeParts, MarksNameMoveAndNumberParts) {
  const std::string way = point(4, 3) + said(0.) + said(0.) + said(30.);
  const Found found(
      call("view", said("front") + point(0, 0), 2, "") +
      call("explode", way, 1,
           call("part", said("lid/1"), 1, "cube();") + call("part", said("pin"), 1, "sphere();")) +
      kMoved + "{ " + call("ink", said("woodcut"), 1, call("callout", said(4.), 1, "cylinder();")) +
      "}");
  EXPECT_EQ(found.names(), (Names{"lid-1", "pin", "a"}));
  const ModelMarks& marks = found.marks;
  EXPECT_EQ(marks.view, "front");
  EXPECT_FALSE(marks.up);
  ASSERT_EQ(marks.steps.size(), 1U);
  EXPECT_EQ(marks.steps[0].parts, (Names{"/lid-1", "/pin"}));
  EXPECT_EQ(marks.steps[0].move, Vec3(0, 0, 30));
  ASSERT_EQ(marks.looks.size(), 1U);
  EXPECT_EQ(marks.looks[0].part, "/a");
  EXPECT_EQ(marks.looks[0].style, "woodcut");
  EXPECT_TRUE(marks.looks[0].hatched && marks.looks[0].listed);
  EXPECT_EQ(marks.items, (std::vector<std::pair<double, std::string>>{{4, "/a"}}));
  EXPECT_TRUE(marks.callouts);
  EXPECT_TRUE(found.diagnostics.empty());
}

TEST(TreeParts, AModuleOfNothingButMarksIsNoPart) {
  const Found found("group() { " + call("view", said("top"), 1, "") + "}\ncube();");
  EXPECT_EQ(found.names(), Names{"a"});
  EXPECT_EQ(found.marks.view, "top");
}

TEST(TreeParts, NothingIsAskedOfPartsOfWhichNothingCame) {
  Found found(
      call("explode", point(4, 3) + said(0.) + said(0.) + said(30.), 1,
           call("part", said("lid"), 1, "cube();") + call("part", said("pin"), 1, "sphere();")) +
      "#cube();");
  ASSERT_EQ(found.names(), (Names{"lid", "pin", "a (highlighted)"}));
  const ModelMarks marks = found.asked({false, true, false});
  ASSERT_EQ(marks.steps.size(), 1U);
  EXPECT_EQ(marks.steps[0].parts, Names{"/pin"});
  EXPECT_TRUE(marks.looks.empty());
  EXPECT_TRUE(found.asked({false, false, false}).empty());
}

TEST(TreeParts, AlphaIsWhatCoversLittle) {
  const Found found(
      "color([1, 0, 0, 0.25]) { cube(); }\ncolor([-1, -1, -1, 0.5]) { sphere(); }\n"
      "color([-1, -1, -1, 0.5]) { color([0, 0, 1, 1]) { sphere(); } }\n"
      "difference() { color([0, 0, 1, 0.75]) { cube(); } sphere(); }\n"
      "group() { color([1, 0, 0, 1]) { cube(); } color([1, 0, 0, 0.5]) { sphere(); } }");
  ASSERT_EQ(found.parts.parts.size(), 6U);
  const auto opacity = [&](std::size_t i) { return found.parts.parts[i].opacity; };
  EXPECT_EQ(opacity(0), 0.25);
  EXPECT_EQ(opacity(1), 0.5);  // the colour that nobody gave
  EXPECT_EQ(found.parts.parts[1].color, "");
  EXPECT_EQ(opacity(2), 1);
  EXPECT_EQ(opacity(3), 0.75);
  EXPECT_EQ(opacity(4), 1);
  EXPECT_EQ(opacity(5), 0.5);
}

TEST(TreeParts, EachCallOfPartIsOne) {
  std::string loop;
  for (int i = 0; i < 3; ++i) {
    loop += "multmatrix([[1,0,0," + std::to_string(9 * i) + "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { " +
            call("part", said("bolt"), 1, "cube(); " + kMoved + " { sphere(); }") + "}";
  }
  const Found found("group() { " + loop + "}");
  EXPECT_EQ(found.names(), (Names{"bolt", "bolt #2", "bolt #3"}));
  for (const TreePart& p : found.parts.parts) {
    EXPECT_EQ(p.definition, "bolt");
    // What differs by where the part stands is its frame alone.
    ASSERT_EQ(p.pieces.size(), 1U);
    EXPECT_EQ(p.pieces[0].at, csg::Matrix{});
  }
  EXPECT_EQ(found.parts.parts[2].frame.row[0][3], 18);
}

TEST(TreeParts, LooksPartWhatIsOneThing) {
  const std::string red = "color([1, 0, 0, 1]) { cube(); } ", blue = "color([0, 0, 1, 1]) { ";
  const Found found(call("part", said("led"), 1,
                         red + call("part", said("leg"), 1, "sphere();") + blue + "cylinder(); } " +
                             call("explode", point(4, 3) + said(0.) + said(0.) + said(9.), 1,
                                  "cube(size = 3);")) +
                    call("part", said("led"), 1, red + blue + "sphere(); }"));
  EXPECT_EQ(found.names(),
            (Names{"#ff0000", "#0000ff", "uncoloured", "leg", "#ff0000", "#0000ff"}));
  Names assemblies;
  for (const TreePart& p : found.parts.parts) assemblies.push_back(p.assembly);
  EXPECT_EQ(assemblies, (Names{"led", "led", "led", "", "led #2", "led #2"}));
  EXPECT_EQ(found.parts.parts[4].definition, "led");
  // What is said of a piece is said of it alone.
  ASSERT_FALSE(found.marks.steps.empty());
  EXPECT_EQ(found.marks.steps[0].parts, Names{"/led/uncoloured"});
}

TEST(TreeParts, MarksThatSayNothingUsefulAreTold) {
  const Found found(call("explode", said("up"), 1, "cube();") +
                    call("part", point(0, 0), 1, "sphere();"));
  EXPECT_EQ(found.names(), (Names{"a", "a #2"}));
  EXPECT_EQ(found.diagnostics.entries().size(), 2U);
}

TEST(Marks, BrokenOnesAreRefused) {
  RunContext context;
  const auto mark = [&](const std::string& points) {
    const csg::Tree tree = csg::parse(
        "polyhedron(points = [[0.271828, 0.314159, 0.141421]" + points + "], faces = []);", "a",
        context);
    return mark_at(tree, 1);
  };
  EXPECT_THROW(mark(""), InputError);
  EXPECT_THROW(mark(", [4, 1, 0], [3, 1e9, 0]"), InputError);
  EXPECT_THROW(mark(", [4, 1, 0], [3, 1, 0], [-5, 0, 0]"), InputError);
  EXPECT_THROW(mark(", [9, 1, 0]"), InputError);
  EXPECT_THROW(mark(", [4, 1, 0], [3, 1, 0], 7"), InputError);
  // Other characters come as they are.
  const auto good = mark(", [4, 1, 0], [3, 3, 0], [228, 0, 0], [8364, 0, 0], [128512, 0, 0]");
  ASSERT_TRUE(good);
  EXPECT_EQ(good->what, "ä€😀");
}

TEST(Parts, HaveUnknownFacetsWherePointsAreWrittenDown) {
  const auto unknown = [](const std::string& text) {
    const Found found(text);
    return has_unknown_facets(found.tree, found.parts.parts.at(0));
  };
  EXPECT_TRUE(unknown("linear_extrude(height = 1) { polygon(points = [[0,0],[1,0],[0,1]]); }"));
  EXPECT_FALSE(unknown("cylinder(h = 1, r1 = 1, r2 = 1);"));
  // The brightness of a picture comes in steps.
  EXPECT_FALSE(unknown("surface(file = \"a.png\", center = false, invert = false);"));
}

}  // namespace
}  // namespace burin::detail
