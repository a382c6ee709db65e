// What objects of a program are called.

#include "source_names.h"

#include <gtest/gtest.h>

namespace burin::detail {
namespace {

using Names = std::vector<std::string>;

TEST(SourceNames, TheInnermostModuleOfAUser) {
  EXPECT_EQ(source_names("translate([1, 2, 3]) color(\"red\") arm(3);\nlid();", 2),
            (Names{"arm", "lid"}));
  EXPECT_EQ(source_names("for (i = [0:3]) rotate(90 * i) { leg(); }", 1), Names{"leg"});
  EXPECT_EQ(source_names("translate([9, 0]) { x = 2; echo(\"a();\"); scale(x) { leg(); } }", 1),
            Names{"leg"});
  EXPECT_EQ(source_names("translate([9, 0]) { leg(); foot(); }", 1), Names{""});
  EXPECT_EQ(source_names("for (i = [0:3]) rotate(90 * i) leg();", 1), Names{"leg"});
  EXPECT_EQ(source_names("difference() { cube(3); sphere(2); }", 1), Names{""});
}

TEST(SourceNames, WhatMakesNoObjectHasNoName) {
  EXPECT_EQ(
      source_names(
          "$fn = 3; x = [for (i = [1:2]) i];\nuse <a.scad>\nmodule m(a = \"};\") { cube(); }\n"
          "module n() cube();\nfunction f(x) = x == 1 ? 2 : 3;\n"
          "echo(\"; m();\"); assert(true) ; *off(); // gone();\n/* gone(); */ %m(); #n();",
          2),
      (Names{"m", "n"}));
}

TEST(SourceNames, ConditionsThatHoldOrDoNot) {
  const char* const text = "a(); if (x) b(); else { c(); } d();";
  EXPECT_EQ(source_names(text, 3), (Names{"a", "b", "d"}));
  EXPECT_EQ(source_names(text, 2), (Names{"a", "d"}));
  EXPECT_EQ(source_names("if (x) b(); if (y) c(); d();", 2), (Names{"", ""}));
}

TEST(SourceNames, TextsThatAreNotUnderstoodGiveNone) {
  EXPECT_EQ(source_names("include <a.scad>\na();", 1), Names{""});
  EXPECT_EQ(source_names("a(); b(", 1), Names{""});
  EXPECT_EQ(source_names("", 2), (Names{"", ""}));
  EXPECT_EQ(source_names("/* a", 1), Names{""});
  EXPECT_EQ(source_names("a() { \"", 1), Names{"a"});
}

}  // namespace
}  // namespace burin::detail
