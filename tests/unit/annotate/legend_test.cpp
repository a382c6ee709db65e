/// The legend of colours in a corner of the sheet.

#include <burin/annotate/annotate.h>
#include <burin/annotate/legend_box.h>
#include <burin/drawing/font.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin {
namespace {

Annotations three_colors() {
  Annotations over;
  over.items = {{1, "plate", {0}, "", ""}, {2, "bolt", {1, 2}, "", ""}, {3, "cover", {3}, "", ""}};
  over.margin = Margin(10);
  for (const DrawingItem& item : over.items) {
    LegendRow row{item.number, item.name, {}};
    row.square.part = item.parts.front();
    row.square.fill = "#77aadd";
    over.legend.push_back(row);
  }
  return over;
}

Drawing laid(const Annotations& over, const CalloutOptions& style = {}) {
  Drawing drawing;
  lay_tables(drawing, over, style);
  return drawing;
}

TEST(Legend, HasASquareAndANameARowWithinTheMargin) {
  const Drawing drawing = laid(three_colors());
  ASSERT_EQ(drawing.areas.size(), 3u);
  ASSERT_EQ(drawing.layers.size(), 1u);
  const Layer& layer = drawing.layers[0];
  EXPECT_EQ(layer.name, "legend");
  ASSERT_EQ(layer.texts.size(), 3u);
  ASSERT_EQ(layer.paths.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Area& square = drawing.areas[i];
    EXPECT_EQ(square.role, "legend");
    EXPECT_EQ(square.fill, "#77aadd");
    EXPECT_EQ(square.rings.at(0), layer.paths[i].points) << "its border lies on it";
    const Vec2 low = square.rings[0][0], high = square.rings[0][2];
    EXPECT_NEAR(high.x - low.x, 3.5, 1e-9);
    EXPECT_NEAR(high.y - low.y, 3.5, 1e-9);
    EXPECT_GE(low.y, 10);
    EXPECT_LE(high.x, 287);
    EXPECT_GT(layer.texts[i].at.x, high.x);
    EXPECT_NEAR(layer.texts[i].at.y + 1.25, 0.5 * (low.y + high.y), 1e-9);
    if (i > 0) {
      EXPECT_LT(high.y, drawing.areas[i - 1].rings[0][0].y) << "from the top down";
    }
  }
  EXPECT_EQ(layer.texts[1].text, "bolt");
  EXPECT_EQ(layer.texts[1].item, 2);
}

TEST(Legend, OfLongNamesShowsWhatTellsThemApart) {
  Annotations over = three_colors();
  const std::string screw = "Hexagon socket head cap screw with flange, stainless steel A2-70 M";
  const std::vector<std::string> names = {screw + "8x30 DIN 912", screw + "8x40 DIN 912",
                                          "Hexagon socket head cap nut of brass, with a collar"};
  for (std::size_t i = 0; i < 3; ++i) over.legend[i].name = over.items[i].name = names[i];
  over.parts_list = true;
  const Drawing drawing = laid(over);
  for (const Layer& layer : drawing.layers) {
    std::vector<std::string> texts;
    for (const Text& text : layer.texts) {
      if (text.text.starts_with("Hexagon")) texts.push_back(text.text);
    }
    ASSERT_EQ(texts.size(), 3u) << layer.name;
    // Where they are cut depends on the font.
    for (const std::string part : {"...M8x30", "...M8x40", "socket head cap nut"}) {
      const auto has = [&](const std::string& text) { return text.find(part) != text.npos; };
      EXPECT_EQ(std::ranges::count_if(texts, has), 1) << part << " in " << layer.name;
    }
    for (const std::string& text : texts) EXPECT_LE(text_width(text, 2.5), 24 * 2.5 + 1e-6);
  }
}

TEST(Legend, StandsInTheCornerThatIsNamedAndLeavesTheRest) {
  const Paper paper{297, 210};
  for (const Corner corner :
       {Corner::BottomRight, Corner::BottomLeft, Corner::TopRight, Corner::TopLeft}) {
    CalloutOptions style;
    style.legend = corner;
    const Drawing drawing = laid(three_colors(), style);
    const Box2 rest = beside_tables(three_colors(), style, paper);
    const Vec2 at = drawing.areas.at(1).rings[0][0];
    const bool right = corner == Corner::BottomRight || corner == Corner::TopRight;
    const bool top = corner == Corner::TopRight || corner == Corner::TopLeft;
    EXPECT_EQ(at.x > 148.5, right);
    EXPECT_EQ(at.y > 105, top);
    EXPECT_FALSE(rest.contains(at));
    EXPECT_TRUE(legend_box(three_colors(), style, paper).value().contains(at));
    EXPECT_GT(rest.size().x * rest.size().y, 0.7 * 277 * 190);
  }
}

TEST(Legend, OfRowsThatAreSeenKeepsToTheRoomOfAll) {
  const Paper paper{148, 105};
  for (const Corner corner :
       {Corner::BottomRight, Corner::BottomLeft, Corner::TopRight, Corner::TopLeft}) {
    CalloutOptions style;
    style.legend = corner;
    for (std::size_t all = 1; all <= 24; ++all) {
      Annotations over = three_colors();
      over.legend.resize(all, over.legend.front());
      const auto room = legend_box(over, style, paper);
      ASSERT_TRUE(room) << all;
      const Box2 rest = beside_tables(over, style, paper);
      for (std::size_t seen = all; seen > 0; --seen) {
        const Box2 box = legend_box(over, style, paper).value();
        EXPECT_FALSE(box.overlaps(rest)) << seen << " of " << all;
        EXPECT_TRUE(room->contains(box.min) && room->contains(box.max)) << seen << " of " << all;
        Drawing drawing;
        drawing.paper_width = paper.width, drawing.paper_height = paper.height;
        lay_tables(drawing, over, style);
        ASSERT_EQ(drawing.areas.size(), seen);
        for (const Area& square : drawing.areas) {
          for (const Vec2& p : square.rings[0]) EXPECT_TRUE(box.contains(p));
        }
        over.legend[seen - 1].seen = false;
      }
      EXPECT_FALSE(legend_box(over, style, paper)) << "none is seen";
    }
  }
}

TEST(Legend, LeavesTheDrawingItsLargestScale) {
  const Paper paper{105, 74};
  const auto scale = [&](Vec2 shape, const Box2& rest) {
    return std::min(rest.size().x / shape.x, rest.size().y / shape.y);
  };
  for (const Vec2 shape : {Vec2(80, 20), Vec2(50, 50), Vec2(20, 80)}) {
    for (std::size_t rows = 1; rows <= 6; ++rows) {
      Annotations over = three_colors();
      over.legend.resize(rows, over.legend.front());
      const double unknown = scale(shape, beside_tables(over, {}, paper));
      over.shape = shape;
      EXPECT_GE(scale(shape, beside_tables(over, {}, paper)), unknown) << shape.x << ' ' << rows;
    }
  }
  Annotations over = three_colors();
  over.shape = {80, 10};
  EXPECT_EQ(beside_tables(over, {}, paper).size().x, 85) << "above what is wide";
  over.shape = {10, 80};
  EXPECT_EQ(beside_tables(over, {}, paper).size().y, 54) << "beside what is high";
}

TEST(Legend, StandsBesideTheListOfParts) {
  Annotations over = three_colors();
  over.parts_list = true;
  const Box2 list = parts_list_box(over, {}, {297, 210}).value();
  const Drawing drawing = laid(over);
  ASSERT_EQ(drawing.layers.size(), 2u);
  for (const Area& square : drawing.areas) {
    for (const Vec2& p : square.rings[0]) EXPECT_FALSE(list.contains(p));
  }
}

TEST(Legend, WithoutRoomIsTold) {
  Drawing drawing;
  drawing.paper_width = drawing.paper_height = 30;
  lay_tables(drawing, three_colors(), {});
  EXPECT_TRUE(drawing.areas.empty());
  ASSERT_EQ(drawing.diagnostics.entries().size(), 1u);
  EXPECT_EQ(drawing.diagnostics.entries()[0].code, "legend.no_room");
}

}  // namespace
}  // namespace burin
