/// Letters as outlines, and the parts list as a file.

#include <burin/drawing/font.h>
#include <burin/drawing/parts_list.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin {
namespace {

Text text(std::string words, TextAnchor anchor = TextAnchor::Start) {
  return {{20, 30}, 5, anchor, std::move(words)};
}

Box2 box_of(const Ink& ink) {
  Box2 box;
  for (const auto& chain : ink.chains) {
    for (const CubicBezier& c : chain) {
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) box.add(evaluate(c, t));
    }
  }
  return box;
}

TEST(Font, CapitalsHaveTheHeightThatIsAsked) {
  const Box2 box = box_of(text_ink(text("H")));
  EXPECT_NEAR(box.min.y, 30, 0.05);
  EXPECT_NEAR(box.max.y, 35, 0.05);
  // Digits too, which numbers of callouts are made of.
  const Box2 digits = box_of(text_ink(text("0123456789")));
  EXPECT_NEAR(digits.max.y - digits.min.y, 5, 0.35);
}

TEST(Font, AnchorsAreWhereTheySay) {
  const double width = text_width("Burin 42", 5);
  EXPECT_GT(width, 15);
  for (const auto& [anchor, start] : {std::pair{TextAnchor::Start, 20.0},
                                      {TextAnchor::Middle, 20 - 0.5 * width},
                                      {TextAnchor::End, 20 - width}}) {
    const Box2 box = box_of(text_ink(text("Burin 42", anchor)));
    EXPECT_NEAR(box.min.x, start, 1.2);
    EXPECT_NEAR(box.max.x, start + width, 0.8);
  }
  EXPECT_NEAR(text_width("Burin 42", 10), 2 * width, 1e-9);
}

TEST(Font, HasLettersOfManyAlphabetsAndCountsWhatItHasNot) {
  EXPECT_EQ(missing_glyphs("Schraube Größe ø 12 µm"), 0U);
  EXPECT_EQ(missing_glyphs("Болт Ωμέγα"), 0U);
  EXPECT_EQ(missing_glyphs("ab\xF0\x9F\x94\xA9"), 1U);
  EXPECT_FALSE(text_ink(text("\xF0\x9F\x94\xA9")).chains.empty()) << "a box stands for it";
  EXPECT_TRUE(text_ink(text(" ")).chains.empty());
}

TEST(Font, OutlinesAreClosedAndTextsAreCutToAWidth) {
  const Ink ink = text_ink(text("8g%"));
  for (const auto& chain : ink.chains) {
    EXPECT_LT(glm::distance(chain.front()[0], chain.back()[3]), 1e-9);
  }
  EXPECT_EQ(fitted_text("bolt", 5, 100), "bolt");
  const std::string cut = fitted_text("a very long name of a part", 5, 30);
  EXPECT_TRUE(cut.ends_with("...")) << cut;
  EXPECT_LE(text_width(cut, 5), 30);
}

/// Reads CSV by the letter of RFC 4180.
std::vector<std::vector<std::string>> read_csv(const std::string& csv) {
  std::vector<std::vector<std::string>> rows(1, {""});
  bool quoted = false;
  for (std::size_t i = 0; i < csv.size(); ++i) {
    const char c = csv[i];
    if (quoted && c == '"' && i + 1 < csv.size() && csv[i + 1] == '"') {
      rows.back().back() += '"';
      ++i;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().emplace_back();
    } else if (!quoted && c == '\r' && i + 1 < csv.size() && csv[i + 1] == '\n') {
      rows.push_back({""});
      ++i;
    } else {
      rows.back().back() += c;
    }
  }
  rows.pop_back();
  return rows;
}

TEST(PartsList, OfAnyNamesReadsBack) {
  const std::vector<std::string> names = {
      "bolt",      "a,b", "say \"so\"", "two\nlines", "two\r\nlines",     "\"",
      "",          ",,",  "größe ø",    "螺栓",       "\xF0\x9F\x94\xA9", "=1+1",
      "tab\there", "\\",  "a\"b,c\nd",  " blanks ",   "{\"x\": 1}",       "%s"};
  std::vector<DrawingItem> items;
  for (const std::string& name : names) {
    items.push_back({static_cast<int>(items.size()) + 1,
                     name,
                     {0, 1, 2},
                     "#ff0000",
                     "a,b.step",
                     {"/a", "/b c", "/d"}});
  }
  const auto rows = read_csv(parts_list_csv(items));
  ASSERT_EQ(rows.size(), names.size() + 1);
  EXPECT_EQ(rows[0],
            (std::vector<std::string>{"number", "name", "quantity", "colour", "source", "parts"}));
  const auto json = nlohmann::json::parse(parts_list_json(items));
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(rows[i + 1], (std::vector<std::string>{std::to_string(i + 1), names[i], "3",
                                                     "#ff0000", "a,b.step", "/a;/b c;/d"}));
    EXPECT_EQ(json["items"][i]["name"], names[i]);
    EXPECT_EQ(json["items"][i]["quantity"], 3);
    EXPECT_EQ(json["items"][i]["parts"], nlohmann::json({"/a", "/b c", "/d"}));
  }
  EXPECT_EQ(read_csv(parts_list_csv({})).size(), 1U);
  EXPECT_TRUE(nlohmann::json::parse(parts_list_json({}))["items"].empty());
}

}  // namespace
}  // namespace burin
