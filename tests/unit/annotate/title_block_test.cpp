// The title block: where it stands, what it says, and that no letter is over a line.
#include <burin/annotate/annotate.h>
#include <burin/drawing/font.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace burin {
namespace {

Annotations with_block(std::map<std::string, std::string> fields = {}) {
  Annotations over;
  over.margin = Margin(10);
  over.title_block.emplace().fields = std::move(fields);
  return over;
}

Drawing sheet(const Paper& paper) {
  Drawing drawing;
  drawing.paper_width = paper.width;
  drawing.paper_height = paper.height;
  drawing.parts = {{0, "plate", "models/plate.step"}};
  drawing.view.scale = 0.5;
  return drawing;
}

Drawing laid(const Annotations& over, const Paper& paper) {
  Drawing drawing = sheet(paper);
  lay_tables(drawing, over, {});
  return drawing;
}

const Layer* block_of(const Drawing& drawing) {
  const auto found = std::ranges::find(drawing.layers, "title_block", &Layer::name);
  return found == drawing.layers.end() ? nullptr : &*found;
}

bool says(const Layer& layer, const std::string& text) {
  return std::ranges::find(layer.texts, text, &Text::text) != layer.texts.end();
}

bool told(const Drawing& drawing, const char* code) {
  return std::ranges::any_of(drawing.diagnostics.entries(),
                             [&](const Diagnostic& d) { return d.code == code; });
}

/// The letters of a text: from the base line to the height of capitals.
Box2 letters(const Text& text) {
  Box2 box = text_box(text);
  box.min.y = text.at.y;
  box.max.y = text.at.y + text.height;
  return box;
}

/// No text is over a line of the block or over another, and all is on it.
void expect_clean(const Layer& layer, const Box2& whole) {
  const Box2 wide{whole.min - 1e-6, whole.max + 1e-6};
  for (const Path& path : layer.paths) {
    for (const Vec2& p : path.points) EXPECT_TRUE(wide.contains(p)) << p.x << ", " << p.y;
  }
  for (std::size_t i = 0; i < layer.texts.size(); ++i) {
    const Box2 box = letters(layer.texts[i]);
    EXPECT_TRUE(wide.contains(box.min) && wide.contains(box.max)) << layer.texts[i].text;
    for (const Path& path : layer.paths) {
      const std::size_t n = path.points.size();
      for (std::size_t k = path.closed ? 0 : 1; k < n; ++k) {
        Box2 line;  // all are level or upright
        line.add(path.points[(k + n - 1) % n]);
        line.add(path.points[k]);
        if (line.size().x > 0 && line.size().y > 0) continue;  // the symbol
        EXPECT_FALSE(line.overlaps(box)) << layer.texts[i].text;
      }
    }
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(letters(layer.texts[k]).overlaps(box))
          << layer.texts[k].text << " and " << layer.texts[i].text;
    }
  }
}

std::map<std::string, std::string> all_fields(const std::string& value) {
  std::map<std::string, std::string> fields;
  for (const TitleBlockField& field : title_block_fields()) fields[field.name] = value;
  return fields;
}

TEST(TitleBlock, IsThatOfIso7200InTheLowerRightCorner) {
  const Paper a4 = Paper::named("A4");
  const Drawing drawing = laid(with_block({{"number", "BP-100"}}), a4);
  const Layer* block = block_of(drawing);
  ASSERT_NE(block, nullptr);
  expect_clean(*block, {{297 - 10 - 180, 10}, {297 - 10, 46}});
  EXPECT_TRUE(says(*block, "BP-100"));
  EXPECT_TRUE(says(*block, "plate"));
  EXPECT_TRUE(says(*block, "plate.step"));
  EXPECT_TRUE(says(*block, "1:2"));
  EXPECT_TRUE(drawing.diagnostics.entries().empty());
  // Nothing of it is over what drawings keep.
  EXPECT_GE(beside_tables(with_block(), {}, a4).min.y, 46);
}

TEST(TitleBlock, KeepsLettersOffItsLinesWhateverTheySay) {
  for (const char* paper : {"A4", "A4p", "A3", "170x120", "142x120", "A5p"}) {
    for (const char* value :
         {"W", "2026-11-29", "Geh\xC3\xA4useunterteil mit Lagerbuchse und Dichtungsnut rechts",
          "Donaudampfschifffahrtselektrizit\xC3\xA4tenhauptbetriebswerk"}) {
      const Paper sheet_of = Paper::named(paper);
      const Annotations over = with_block(all_fields(value));
      const Drawing drawing = laid(over, sheet_of);
      const Layer* block = block_of(drawing);
      ASSERT_NE(block, nullptr) << paper;
      SCOPED_TRACE(std::string(paper) + " " + value);
      expect_clean(*block, {{10, 10}, {sheet_of.width - 10, 46}});
      const bool is_cut = told(drawing, "title_block.cut");
      const bool is_long = *value != 'W' && *value != '2';
      if (*value != '2') {
        EXPECT_EQ(is_cut, is_long);
      }
      EXPECT_EQ(told(drawing, "title_block.narrow"), sheet_of.width < 200);
    }
  }
}

TEST(TitleBlock, HasTwoLinesBeforeSmallerLettersBeforeDots) {
  const auto title = [](const std::string& text) {
    const Drawing drawing = laid(with_block({{"title", text}}), Paper::named("A4"));
    std::vector<Text> lines;
    for (const Text& line : block_of(drawing)->texts) {
      if (line.at.x > 168 - 1e-9 && line.at.x < 169 && line.at.y < 25.2) lines.push_back(line);
    }
    return lines;
  };
  EXPECT_EQ(title("Pump").size(), 1U);
  const std::vector<Text> two = title("Zahnradpumpe mit Antriebswelle links");
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].height, 3.5);
  EXPECT_EQ(two[0].text + " " + two[1].text, "Zahnradpumpe mit Antriebswelle links");
  const std::vector<Text> small = title("Geh\xC3\xA4useunterteil mit Lagerbuchse und Dichtungsnut");
  ASSERT_EQ(small.size(), 2U);
  EXPECT_LT(small[0].height, 3.5);
  EXPECT_GE(small[0].height, 1.8);
}

TEST(TitleBlock, SaysNothingThatNobodyKnows) {
  const Drawing drawing = laid(with_block({{"model", ""}}), Paper::named("A4"));
  const Layer& block = *block_of(drawing);
  // Labels of 15 cells, title and scale.
  EXPECT_EQ(block.texts.size(), 17U);
  EXPECT_FALSE(says(block, "plate.step"));
  Drawing deep = sheet(Paper::named("A4"));
  deep.view.projection = "perspective";
  lay_tables(deep, with_block({{"model", ""}}), {});
  EXPECT_EQ(block_of(deep)->texts.size(), 16U) << "no scale";
}

TEST(TitleBlock, IsLeftOutWhereASheetIsTooSmallAndSaysSo) {
  const Paper label = Paper::named("105x74");
  const Drawing drawing = laid(with_block(), label);
  EXPECT_EQ(block_of(drawing), nullptr);
  EXPECT_TRUE(told(drawing, "title_block.no_room"));
  EXPECT_EQ(beside_tables(with_block(), {}, label).size(), Vec2(85, 54));
  EXPECT_FALSE(annotations_fit(with_block(), {}, label, Margin(10)));
  EXPECT_FALSE(annotations_fit(with_block(), {}, Paper::named("A5p"), Margin(10))) << "narrower";
  EXPECT_TRUE(annotations_fit(with_block(), {}, Paper::named("A5"), Margin(10, 10, 60, 10)));
}

TEST(TitleBlock, CarriesThePartsListAndLeavesTheLargerPlace) {
  Annotations over = with_block();
  over.items = {{1, "body", {0}, "", ""}, {2, "cover", {1}, "", ""}};
  over.parts_list = true;
  const Paper a3 = Paper::named("A3");
  const auto list = parts_list_box(over, {}, a3);
  ASSERT_TRUE(list);
  EXPECT_EQ(list->min.y, 46);
  EXPECT_EQ(list->max.x, 410);
  EXPECT_FALSE(beside_tables(over, {}, a3).overlaps(*list));
  // A tall drawing stands beside a block without a list, a wide one above it.
  over.parts_list = false;
  over.shape = {1, 3};
  EXPECT_EQ(beside_tables(over, {}, a3).min.y, 10);
  over.shape = {3, 1};
  EXPECT_EQ(beside_tables(over, {}, a3).max.x, 410);
}

TEST(TitleBlock, HasTheSymbolOfTheMethodWhereThereIsRoom) {
  Annotations over = with_block();
  EXPECT_TRUE(has_symbol(over, {}, Paper::named("A4")));
  EXPECT_FALSE(has_symbol(over, {}, Paper::named("A5p")));
  EXPECT_FALSE(has_symbol({}, {}, Paper::named("A4")));
  const std::size_t without = block_of(laid(over, Paper::named("A4")))->paths.size();
  over.title_block->method = ProjectionMethod::ThirdAngle;
  const Drawing drawing = laid(over, Paper::named("A4"));
  EXPECT_EQ(block_of(drawing)->paths.size(), without + 6);
  expect_clean(*block_of(drawing), {{107, 10}, {287, 46}});
}

TEST(TitleBlock, OfATemplateStandsInTheCornerOrIsTheSheet) {
  TitleBlockLayout layout;
  layout.size = {100, 20};
  layout.texts = {{{{5, 5}, 3, TextAnchor::Start, "NAME", "title_block"}, "title"},
                  {{{5, 15}, 3, TextAnchor::Start, "NONE", "title_block"}, "weight"},
                  {{{50, 15}, 3, TextAnchor::Start, "fixed", "title_block"}, ""}};
  Annotations over = with_block();
  over.title_block->layout = std::make_shared<TitleBlockLayout>(layout);
  const Drawing small = laid(over, Paper::named("A4"));
  const std::vector<Text>& texts = block_of(small)->texts;
  ASSERT_EQ(texts.size(), 3U);
  EXPECT_EQ(texts[0].text, "plate");
  EXPECT_EQ(texts[1].text, "NONE");
  EXPECT_EQ(texts[2].text, "fixed");
  EXPECT_EQ(texts[0].at, Vec2(187 + 5, 10 + 5));
  over.title_block->fields["weight"] = "";
  EXPECT_EQ(block_of(laid(over, Paper::named("A4")))->texts.size(), 2U);
  layout.size = {297, 210};
  layout.kept_clear = Box2{{197, 10}, {287, 40}};
  over.title_block->layout = std::make_shared<TitleBlockLayout>(layout);
  EXPECT_EQ(block_of(laid(over, Paper::named("A4")))->texts[0].at, Vec2(5, 5));
  EXPECT_FALSE(beside_tables(over, {}, Paper::named("A4")).overlaps(*layout.kept_clear));
  EXPECT_TRUE(told(laid(over, Paper::named("A5")), "title_block.no_room"));
}

}  // namespace
}  // namespace burin
