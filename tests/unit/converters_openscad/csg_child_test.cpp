#include <burin/base/error.h>

#include "child.h"
#include "csg_worked.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace burin::csg::test {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<Solid> by_child(const std::string& text, std::vector<std::uint32_t> nodes,
                            RunContext& context, Diagnostics& diagnostics) {
  return evaluate_in_child(text, nodes, {.folder = ".", .file = "test.csg"}, context, diagnostics);
}

/// Hundreds of round things through each other: minutes of work.
std::string long_work() {
  std::string text = "difference() { " + sphere(50, 400);
  for (int i = 0; i < 60; ++i)
    text += moved(i * 0.37, i * 0.11, 0.013 * i, turned(6 * i, sphere(49.5, 300)));
  return text + "}";
}

TEST(Child, GivesWhatTheLibraryGives) {
  const std::string text =
      "difference() { " + moved(-5, -5, -5, cube(10, 10, 10)) + cylinder(30, 2, 2, 32) + "}";
  RunContext context;
  Diagnostics diagnostics;
  const std::vector<Solid> both = by_child(text, {0, 2}, context, diagnostics);
  ASSERT_EQ(both.size(), 2u);
  const Solid here = work_out(text).solid;
  EXPECT_EQ(both[0].positions, here.positions);
  EXPECT_EQ(both[0].triangles, here.triangles);
  EXPECT_EQ(both[0].surface, here.surface);
  EXPECT_EQ(both[0].surfaces.size(), here.surfaces.size());
  EXPECT_NEAR(volume(both[1]), 1000, 1e-9);
}

TEST(Child, HandsDiagnosticsOn) {
  RunContext context;
  Diagnostics diagnostics;
  by_child(cube(1, 1, 1) + "square(size = [1, 1], center = false);", {0}, context, diagnostics);
  ASSERT_EQ(diagnostics.entries().size(), 1u);
  EXPECT_EQ(diagnostics.entries()[0].code, "openscad.mixed_dimensions");
  EXPECT_EQ(diagnostics.entries()[0].severity, Severity::Warning);
}

TEST(Child, RefusesByFileAndLineOfTheTree) {
  RunContext context;
  Diagnostics diagnostics;
  const std::string texts[] = {"\n\nsphere($fn = 1e9, $fa = 12, $fs = 2, r = 1);",
                               "\n\ncube(size = [1,1,1]", "\n\nfor(i = [1:2]) cube(1);"};
  for (const std::string& text : texts) {
    try {
      by_child(text, {0}, context, diagnostics);
      ADD_FAILURE() << text;
    } catch (const InputError& e) {
      EXPECT_EQ(e.file(), "test.csg") << text;
      EXPECT_EQ(e.line(), 0) << text;
      EXPECT_TRUE(std::string(e.what()).starts_with("line 3 of the evaluated tree: ")) << e.what();
    }
  }
}

TEST(Child, WhatIsSaidOfALineIsSaidOfWhatTheUserKnows) {
  RunContext context;
  Diagnostics diagnostics;
  const ChildOptions options{.folder = ".", .file = "test.scad", .where = [](std::int64_t line) {
                               return line == 2 ? std::string("in arm") : std::string();
                             }};
  const std::string text =
      "group(){\nintersection(){ cube(1); }\nlinear_extrude(1){ square(3); cube(4); }}\n"
      "linear_extrude(1){ square(3); cube(4); }";
  for (const std::uint32_t node : {1U, 7U}) {
    evaluate_in_child(text, std::vector{node}, options, context, diagnostics);
  }
  ASSERT_GE(diagnostics.entries().size(), 1U);
  EXPECT_EQ(diagnostics.entries()[0].message,
            "test.scad: cube(): a solid among 2-D objects is left out");
  const auto raised = [&](const std::string& circle) {
    try {
      evaluate_in_child("\n" + circle, std::vector{0U}, options, context, diagnostics);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_TRUE(raised("sphere($fn = 1e9, $fa = 12, $fs = 2, r = 1);").starts_with("in arm: "));
}

TEST(Child, EndsWithinATenthOfASecondOfACancel) {
  RunContext context;
  Diagnostics diagnostics;
  Clock::time_point asked;
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    asked = Clock::now();
    context.cancel();
  });
  EXPECT_THROW(by_child(long_work(), {0}, context, diagnostics), Cancelled);
  later.join();
  EXPECT_LT(std::chrono::duration<double>(Clock::now() - asked).count(), 0.1);
}

TEST(Child, SaysThatItsTimeIsUp) {
  RunContext context;
  Diagnostics diagnostics;
  const std::string text = long_work();
  EXPECT_THROW(evaluate_in_child(text, std::vector<std::uint32_t>{0},
                                 {.folder = ".", .file = "test.csg", .timeout_seconds = 0.5},
                                 context, diagnostics),
               NotEvaluated);
}

TEST(Child, TellsHowFarItIs) {
  std::vector<double> shares;
  RunContext context([&](const std::string&, double share) { shares.push_back(share); });
  context.begin_stage(RunStage::Read);
  Diagnostics diagnostics;
  std::string text = "difference() { " + sphere(50, 100);
  for (int i = 0; i < 5; ++i) text += moved(i, i, i, turned(6 * i, sphere(49, 90)));
  by_child(text + "}", {0}, context, diagnostics);
  ASSERT_GT(shares.size(), 2u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_LE(shares.back(), 1);
}

TEST(Child, ManyNodesAreNoStack) {
  // As deep as long: groups within groups, and as many cubes beside each other.
  constexpr int kDeep = 100'000;
  std::string text;
  for (int i = 0; i < kDeep; ++i) text += "group() {";
  text += cube(1, 1, 1);
  for (int i = 0; i < kDeep; ++i) text += "}";
  for (int i = 1; i < 5000; ++i) text += moved(2 * i, 0, 0, cube(1, 1, 1));
  RunContext context;
  Diagnostics diagnostics;
  EXPECT_NEAR(volume(by_child(text, {0}, context, diagnostics)[0]), 5000, 1e-6);
}

}  // namespace
}  // namespace burin::csg::test
