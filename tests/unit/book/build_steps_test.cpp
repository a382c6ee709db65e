#include <burin/book/build_steps.h>

#include <burin_test/exploded.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace burin {
namespace {

using Parts = std::vector<std::size_t>;

/// Parts by path, "a/b", all of one shape.
Scene scene_of(const std::vector<std::string>& paths) {
  Scene scene;
  for (const std::string& path : paths) {
    std::vector<std::string> names(1);
    for (const char c : path) {
      if (c == '/') {
        names.emplace_back();
      } else {
        names.back() += c;
      }
    }
    const std::string name = names.back();
    names.pop_back();
    test::add_part(scene, name, test::box({0, 0, 0}, {1, 1, 1}), names);
  }
  return scene;
}

ExplodeStep out(Parts parts, bool trail = true) {
  return {{}, std::move(parts), {0, 0, 1}, 10, trail};
}

/// One item a name.
std::vector<int> items_of(const Scene& scene) {
  std::vector<std::string> names;
  std::vector<int> items;
  for (const Part& part : scene.parts) {
    auto found = std::ranges::find(names, part.name);
    if (found == names.end()) found = names.insert(found, part.name);
    items.push_back(static_cast<int>(found - names.begin()) + 1);
  }
  return items;
}

std::vector<BuildStep> built(const Scene& scene, const std::vector<ExplodeStep>& steps,
                             std::size_t items = 6) {
  return build_steps(scene, std::vector<bool>(scene.parts.size(), true), steps, items_of(scene),
                     {items});
}

/// Whatever the steps are: each part is new once where sub-assemblies are built once, what stands
/// is what came before, and the last step shows all.
void expect_whole(const Scene& scene, const std::vector<BuildStep>& steps) {
  Parts there;
  for (const BuildStep& step : steps) {
    if (step.begins) there = step.assembled;
    EXPECT_EQ(there, step.assembled);
    there = step.parts();
    EXPECT_TRUE(std::ranges::adjacent_find(there) == there.end());
  }
  EXPECT_EQ(there.size(), scene.parts.size());
}

TEST(BuildSteps, AreTheStepsBackwards) {
  const Scene scene = scene_of({"base", "ring", "lid"});
  const auto steps = built(scene, {out({2}), out({1})});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_TRUE(steps[0].begins);
  EXPECT_EQ(steps[0].assembled, (Parts{0}));
  EXPECT_EQ(steps[0].moves[0].parts, (Parts{1}));
  EXPECT_FALSE(steps[1].begins);
  EXPECT_EQ(steps[1].assembled, (Parts{0, 1}));
  EXPECT_EQ(steps[1].moves[0].parts, (Parts{2}));
  expect_whole(scene, steps);
}

TEST(BuildSteps, EqualOnesAreOne) {
  const Scene scene = scene_of({"base", "bolt", "bolt", "bolt", "cap"});
  const auto steps = built(scene, {out({4}), out({1}), out({2}), out({3})});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].moves.size(), 3U);
  EXPECT_EQ(steps[1].moves.size(), 1U);
  expect_whole(scene, steps);
}

TEST(BuildSteps, ASubAssemblyIsBuiltBeforeItIsAdded) {
  const Scene scene =
      scene_of({"pump/base", "pump/drive/shaft", "pump/drive/gear", "pump/drive/key"});
  const auto steps = built(scene, {out({1, 2, 3}), out({2}), out({3})});
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].assembly, "drive");
  EXPECT_EQ(steps[0].assembled, (Parts{1}));
  EXPECT_EQ(steps[1].assembly, "drive");
  EXPECT_EQ(steps[2].assembly, "");
  ASSERT_EQ(steps[2].moves.size(), 1U);
  EXPECT_EQ(steps[2].moves[0].parts, (Parts{1, 2, 3}));
  expect_whole(scene, steps);
}

TEST(BuildSteps, SubAssembliesAlikeAreBuiltOnce) {
  const Scene scene =
      scene_of({"a/base", "a/foot 1/pad", "a/foot 1/pin", "a/foot 2/pad", "a/foot 2/pin"});
  const auto steps = built(scene, {out({1, 2, 3, 4}), out({2}), out({4})});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].quantity, 2U);
  EXPECT_EQ(steps[0].assembled, (Parts{1}));
  EXPECT_EQ(steps[1].moves.size(), 2U);
  EXPECT_EQ(steps[1].parts().size(), 5U);
}

TEST(BuildSteps, PartOfASubAssemblyIsItsParts) {
  const Scene scene =
      scene_of({"a/base", "a/set 1/bolt", "a/set 1/nut", "a/set 2/bolt", "a/set 2/nut"});
  const auto steps = built(scene, {out({1, 3}), out({2, 4})});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].moves.size(), 2U);
  EXPECT_EQ(steps[1].moves.size(), 2U);
  expect_whole(scene, steps);
}

TEST(BuildSteps, WhatOnlyFollowsAddsNothing) {
  const Scene scene = scene_of({"base", "rod", "nut"});
  auto follows = out({2}, false);
  follows.along = {1, 0, 0};
  const auto steps = built(scene, {out({2}), out({1}), follows});
  EXPECT_EQ(steps.size(), 2U);
  expect_whole(scene, steps);
}

TEST(BuildSteps, PartsThatHoldEachOtherComeTogether) {
  const Scene scene = scene_of({"base", "hook", "eye"});
  const auto steps = built(scene, {out({1, 2}), out({2})});
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[0].assembly, "hook + eye");
  EXPECT_EQ(steps[1].moves[0].parts, (Parts{1, 2}));
  expect_whole(scene, steps);
}

TEST(BuildSteps, TooManyItemsAreParted) {
  const Scene scene = scene_of({"base", "a", "b", "c", "d", "e", "a"});
  const auto steps = built(scene, {out({1, 2, 3, 4, 5, 6})}, 2);
  for (const BuildStep& step : steps) {
    std::set<int> items;
    for (const BuildMove& move : step.moves) items.insert(items_of(scene)[move.parts[0]]);
    EXPECT_LE(items.size(), 2U);
  }
  expect_whole(scene, steps);
}

TEST(BuildSteps, WhatDoesNotComeApartIsOneStep) {
  const Scene scene = scene_of({"a", "b"});
  const auto steps = built(scene, {});
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_TRUE(steps[0].begins);
  EXPECT_EQ(steps[0].assembled, (Parts{0, 1}));
}

TEST(BuildSteps, PartsThatAreNotDrawnAreNotThere) {
  const Scene scene = scene_of({"base", "lid", "case"});
  const auto steps =
      build_steps(scene, {true, true, false}, {out({2}), out({1, 2})}, items_of(scene), {});
  ASSERT_EQ(steps.size(), 1U);
  EXPECT_EQ(steps[0].parts(), (Parts{0, 1}));
}

TEST(BuildSteps, OfFoundStepsEachPartIsNewOnce) {
  RunContext context;
  const Scene scene = test::stacks(5);
  const ExplodeModel model(scene, std::vector<bool>(scene.parts.size(), true), context);
  Diagnostics said;
  const auto steps = built(scene, model.find({}, said, context).steps);
  expect_whole(scene, steps);
  std::multiset<std::size_t> fresh;
  for (const BuildStep& step : steps) {
    if (step.begins) fresh.insert(step.assembled.begin(), step.assembled.end());
    for (const BuildMove& move : step.moves) fresh.insert(move.parts.begin(), move.parts.end());
  }
  EXPECT_EQ(fresh.size(), scene.parts.size());
  EXPECT_EQ(std::set<std::size_t>(fresh.begin(), fresh.end()).size(), scene.parts.size());
}

TEST(NameTogether, IsThatOfTheAssemblyOrOfTheParts) {
  const Scene scene = scene_of({"p/d/shaft", "p/d/key 1", "p/d/key 2", "p/base"});
  const std::vector<bool> all(4, true);
  EXPECT_EQ(name_together(scene, all, {0, 1, 2}), "d");
  EXPECT_EQ(name_together(scene, all, {0, 1}), "shaft + key");
  EXPECT_EQ(name_together(scene, all, {0, 1, 2, 3}), "p");
  EXPECT_EQ(name_together(scene, {true, true, false, true}, {0, 1}), "d");
  // What is one thing is called by that, not by its colours.
  Scene colours = scene_of({"motor #2/#c0c0c0", "motor #2/#ffd700", "base"});
  colours.parts[1].joined = true;
  EXPECT_EQ(name_together(colours, {true, true, true}, {0, 1, 2}), "motor + base");
}

}  // namespace
}  // namespace burin
