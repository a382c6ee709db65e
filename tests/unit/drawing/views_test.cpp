#include <burin/drawing/views.h>

#include <gtest/gtest.h>

namespace burin {
namespace {

Drawing with_layers(std::initializer_list<const char*> names) {
  Drawing drawing;
  for (const char* name : names) {
    Path path;
    path.points = {{0, 0}, {1, 1}};
    path.width = {0.2};
    drawing.layers.push_back({name, {path}, {{{0, 0}, 3, TextAnchor::Start, name, "detail", 0}}});
  }
  return drawing;
}

std::vector<std::string> names_of(const Drawing& drawing) {
  std::vector<std::string> names;
  for (const Layer& layer : drawing.layers) names.push_back(layer.name);
  return names;
}

TEST(Views, LayersKeepTheirOrder) {
  Drawing sheet = with_layers({"hidden", "crease", "outline"});
  append_view(sheet, with_layers({"hidden", "pattern", "crease", "contour", "outline"}));
  EXPECT_EQ(names_of(sheet),
            (std::vector<std::string>{"hidden", "pattern", "crease", "contour", "outline"}));
  EXPECT_EQ(sheet.layers[0].paths.size(), 2U);
  EXPECT_EQ(sheet.layers[0].texts.size(), 2U);
  EXPECT_EQ(sheet.layers[1].paths.size(), 1U);
}

TEST(Views, LayersOfAnotherOrderAreAllThere) {
  Drawing sheet = with_layers({"a", "b"});
  append_view(sheet, with_layers({"b", "a", "c"}));
  EXPECT_EQ(names_of(sheet), (std::vector<std::string>{"a", "b", "c"}));
  append_view(sheet, with_layers({"x"}));
  EXPECT_EQ(names_of(sheet).front(), "x");
}

TEST(Views, CountsAddUpAndThingsAreToldOnce) {
  Drawing sheet = with_layers({}), view = with_layers({});
  sheet.stats.strokes = 3, view.stats.strokes = 4;
  sheet.stats.triangles = 10, view.stats.triangles = 12;
  view.stats.verify = std::make_optional<Verification>();
  view.stats.verify->spans = 5;
  sheet.diagnostics.add(Severity::Warning, "a", 1, "same");
  view.diagnostics.add(Severity::Warning, "a", 1, "same");
  view.diagnostics.add(Severity::Warning, "a", 1, "other");
  view.areas.push_back({.part = 2, .rings = {}});
  append_view(sheet, Drawing(view));
  append_view(sheet, Drawing(view));
  EXPECT_EQ(sheet.stats.strokes, 11);
  EXPECT_EQ(sheet.stats.triangles, 12);
  ASSERT_TRUE(sheet.stats.verify);
  EXPECT_EQ(sheet.stats.verify->spans, 10);
  EXPECT_EQ(sheet.diagnostics.entries().size(), 2U);
  EXPECT_EQ(sheet.areas.size(), 2U);
}

}  // namespace
}  // namespace burin
