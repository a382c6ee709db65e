#include <burin/annotate/list_pages.h>
#include <burin/assembly/items.h>
#include <burin/book/book.h>

#include <burin_test/exploded.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// A plate with a bush, a washer and a bolt through it, and a nut below.
Scene stack() {
  Scene scene;
  test::add_part(scene, "plate",
                 test::turned({{5.5, -10}, {40, -10}, {40, 0}, {5.5, 0}}, 48, true));
  test::add_part(scene, "washer", test::ring(5.5, 10, 0, 2));
  test::add_part(scene, "bolt", test::bolt(5, 9, -20, 2, 8));
  test::add_part(scene, "nut", test::ring(5.2, 9, -16, -10));
  return scene;
}

class BookOf : public ::testing::Test {
 protected:
  Book make(const Scene& scene, BookOptions options = {}, std::vector<ExplodeStep> steps = {}) {
    const std::vector<bool> all(scene.parts.size(), true);
    const ExplodeModel model(scene, all, context_);
    Diagnostics said;
    if (steps.empty()) steps = model.find({.along = Vec3(0, 0, 1)}, said, context_).steps;
    IllustrateOptions how;
    how.annotations.emplace();
    for (const Item& item : find_items(scene, {}, said, context_)) {
      DrawingItem one{item.number, item.name, {}, "", ""};
      for (const std::size_t part : item.parts)
        one.parts.push_back(static_cast<std::int32_t>(part));
      how.annotations->items.push_back(std::move(one));
    }
    return make_book(scene, model, steps, options, builtin_style("outline"), how, context_);
  }

  static Box2 ink(const Drawing& drawing) {
    Box2 box;
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        for (const Vec2& p : path.points) box.add(p);
      }
    }
    return box;
  }

  /// Parts with visible lines of the shape.
  static std::set<int> seen(const Drawing& drawing) {
    std::set<int> parts;
    for (const Layer& layer : drawing.layers) {
      for (const Path& path : layer.paths) {
        if (path.visible && path.kind != LineClass::Frame && path.kind != LineClass::Trail &&
            path.kind != LineClass::Leader) {
          parts.insert(path.source.part);
        }
      }
    }
    return parts;
  }

  RunContext context_;
};

TEST_F(BookOf, AStackHasAPageForEachPartAndAllThatIsNewIsSeen) {
  const Scene scene = stack();
  const Book book = make(scene);
  ASSERT_GE(book.pages.size(), 2U);
  std::map<std::string, std::size_t> added;
  for (const BookPage& page : book.pages) {
    EXPECT_EQ(page.drawing.views.size(), 0U);
    const std::set<int> parts = seen(page.drawing);
    for (const NewPart& part : page.added) {
      added[part.name] += part.quantity;
      const auto item = std::ranges::find(book.items, part.item, &DrawingItem::number);
      ASSERT_NE(item, book.items.end());
      EXPECT_TRUE(std::ranges::any_of(item->parts, [&](int p) { return parts.contains(p); }))
          << part.name;
    }
    const Box2 box = ink(page.drawing);
    EXPECT_GE(box.min.x, 10 - 0.6);
    EXPECT_GE(box.min.y, 10 - 0.6);
    EXPECT_LE(box.max.x, 287 + 0.6);
    EXPECT_LE(box.max.y, 200 + 0.6);
  }
  EXPECT_EQ(added.size(), 4U);
  for (const auto& [name, count] : added) EXPECT_EQ(count, 1U) << name;
  ASSERT_EQ(book.lists.size(), 1U);
}

TEST_F(BookOf, WhatStandsAlreadyHasLighterLines) {
  const Book book = make(stack());
  double old_widest = 0, new_widest = 0;
  const BookPage& last = book.pages.back();
  const int fresh =
      std::ranges::find(book.items, last.added.at(0).item, &DrawingItem::number)->parts.at(0);
  for (const Layer& layer : last.drawing.layers) {
    for (const Path& path : layer.paths) {
      if (path.kind == LineClass::Frame || path.width.empty()) continue;
      double& widest = path.source.part == fresh ? new_widest : old_widest;
      widest = std::max(widest, path.width[0]);
    }
  }
  EXPECT_GT(old_widest, 0);
  EXPECT_LT(old_widest, 0.6 * new_widest);
}

TEST_F(BookOf, ALongNameKeepsItsQuantity) {
  const std::string name = "column of the bearing with a name that no page has room for";
  Scene scene;
  test::add_part(scene, "base", test::box({0, 0, 0}, {60, 20, 2}));
  for (int i = 0; i < 2; ++i) {
    const double x = 10 + 30 * i;
    const std::vector<std::string> path{fmt::format("{} {}", name, i + 1)};
    test::add_part(scene, "pad", test::box({x, 5, 2}, {x + 10, 15, 4}), path);
    test::add_part(scene, "pin", test::box({x + 4, 9, 4}, {x + 6, 11, 14}), path);
  }
  const auto out = [](std::vector<std::size_t> parts) {
    return ExplodeStep{.parts = std::move(parts), .along = {0, 0, 1}, .by = 10};
  };
  const Book book = make(scene, {}, {out({1, 2, 3, 4}), out({2}), out({4})});
  ASSERT_EQ(book.pages.size(), 2U);
  const auto step = std::ranges::find(book.pages.front().drawing.layers, "step", &Layer::name);
  ASSERT_NE(step, book.pages.front().drawing.layers.end());
  EXPECT_TRUE(std::ranges::any_of(step->texts, [](const Text& text) {
    return text.text.starts_with("column of the") && text.text.ends_with(", 2x");
  }));
}

TEST_F(BookOf, WhatIsHiddenIsLookedAtFromAnotherSide) {
  // The nut goes below a wide plate: from above nothing of it is seen.
  const Book book = make(stack(), {.view = {.direction = {0.1, -0.1, 1}}});
  bool from_below = false;
  for (const BookPage& page : book.pages) {
    const bool nut =
        std::ranges::any_of(page.added, [](const NewPart& p) { return p.name == "nut"; });
    if (nut && page.drawing.view.direction.z < 0) from_below = true;
    if (nut) {
      EXPECT_TRUE(seen(page.drawing).contains(3));
    }
    // Two arrows beside the number say so; the frame about small pictures is there anyway.
    const auto step = std::ranges::find(page.drawing.layers, "step", &Layer::name);
    ASSERT_NE(step, page.drawing.layers.end());
    const auto turned =
        std::ranges::count_if(step->paths, [](const Path& path) { return path.width.size() == 2; });
    EXPECT_EQ(turned, page.drawing.view.direction.z < 0 ? 2 : 0);
  }
  EXPECT_TRUE(from_below);
}

TEST_F(BookOf, WhatCannotBeSeenFromAnywhereIsSeenThroughAGhost) {
  // A ball that is put into a closed shell by hand: no direction shows it.
  Scene scene;
  test::add_part(scene, "shell", test::box({-20, -20, -20}, {20, 20, 20}));
  test::add_part(scene, "core", test::box({-2, -2, -2}, {2, 2, 2}));
  const ExplodeModel model(scene, {true, true}, context_);
  IllustrateOptions how;
  const Book book = make_book(scene, model, {{.parts = {1}, .by = 1}}, {}, builtin_style("outline"),
                              how, context_);
  ASSERT_EQ(book.pages.size(), 1U);
  EXPECT_TRUE(seen(book.pages[0].drawing).contains(1));
}

TEST(ListPages, HaveAllRowsInOrderOnAsManySheetsAsTheyNeed) {
  std::vector<DrawingItem> items;
  for (int i = 1; i <= 100; ++i) items.push_back({i, "part " + std::to_string(i), {0}, "", ""});
  const std::vector<Drawing> pages = list_pages(items, {}, Paper::named("A4"), Margin(10));
  ASSERT_GT(pages.size(), 1U);
  int next = 1;
  for (const Drawing& page : pages) {
    double last = 1e9;
    for (const Text& text : page.layers.at(0).texts) {
      EXPECT_GE(text.at.y, 10);
      EXPECT_LE(text.at.y + text.height, 200);
      if (!text.text.starts_with("part")) continue;
      EXPECT_EQ(text.text, "part " + std::to_string(next++));
      EXPECT_LT(text.at.y, last);
      last = text.at.y;
    }
  }
  EXPECT_EQ(next, 101);
  EXPECT_TRUE(list_pages({}, {}, Paper::named("A4"), Margin(10)).empty());
}

}  // namespace
}  // namespace burin
