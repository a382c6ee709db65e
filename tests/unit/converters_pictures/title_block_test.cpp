// Templates of title blocks: SVG files whose texts are fields.
#include <burin/base/error.h>
#include <burin/base/missing_file.h>
#include <burin/converters/pictures.h>
#include <burin/drawing/font.h>

#include <burin_test/folder.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace burin {
namespace {

class TitleBlockTemplate : public ::testing::Test {
 protected:
  TitleBlockLayout read(const std::string& inside, const std::string& size =
                                                       "width='100mm' height='20mm' "
                                                       "viewBox='0 0 100 20'") {
    return read_title_block(
        folder_.write("t.svg", "<svg xmlns='http://www.w3.org/2000/svg' xmlns:freecad='f' " + size +
                                   ">" + inside + "</svg>"));
  }

  std::string refusal(const std::string& text) {
    try {
      read_title_block(folder_.write("t.svg", text));
    } catch (const InputError& e) {
      return std::to_string(e.line()) + ": " + e.what();
    }
    return "";
  }

  const test::Folder folder_;
};

TEST_F(TitleBlockTemplate, HasLinesAndTextsInPaperMm) {
  const TitleBlockLayout block = read(
      "<g style='fill:none;stroke:#000;stroke-width:0.7' transform='translate(0,1)'>"
      "<rect x='0' y='0' width='100' height='18'/><path d='M50 0v18' stroke-width='0.35'/></g>"
      "<rect width='100' height='20' fill='white' stroke='none'/>"
      "<g style='display:none'><path stroke='#000' d='M0 0h5'/></g>"
      "<text x='2' y='15' font-size='5'>Title</text>"
      "<text x='25' y='15' text-anchor='middle' id='title' style='font-size:5px'>NAME</text>"
      "<text transform='rotate(90)' x='2' y='2'>up</text>");
  EXPECT_EQ(block.size, Vec2(100, 20));
  ASSERT_EQ(block.paths.size(), 2U);
  EXPECT_EQ(block.paths[0].width, std::vector<double>{0.7});
  EXPECT_TRUE(block.paths[0].closed);
  EXPECT_EQ(block.paths[1].width, std::vector<double>{0.35});
  EXPECT_EQ(block.paths[1].points.front(), Vec2(50, 19));
  EXPECT_EQ(block.paths[1].points.back(), Vec2(50, 1));
  ASSERT_EQ(block.texts.size(), 2U);
  EXPECT_EQ(block.texts[0].field, "");
  EXPECT_EQ(block.texts[0].text.text, "Title");
  EXPECT_EQ(block.texts[0].text.at, Vec2(2, 5));
  EXPECT_NEAR(font_size(block.texts[0].text.height), 5, 1e-9);
  EXPECT_EQ(block.texts[1].field, "title");
  EXPECT_EQ(block.texts[1].text.anchor, TextAnchor::Middle);
  // To the line at 50 and to the border.
  EXPECT_NEAR(block.texts[1].width, 49, 1e-9);
  EXPECT_EQ(block.left_out, 1);
}

TEST_F(TitleBlockTemplate, OfTechDrawHasItsFields) {
  const TitleBlockLayout block = read(
      "<!-- Title block 60 5 95 18 --><path d='M1 1h98' stroke='#000'/>"
      "<text freecad:editable='FC-SC' x='1' y='2'><tspan>SCALE</tspan></text>"
      "<text freecad:editable='AUTHOR_NAME' x='1' y='6'><tspan x='3' y='6' "
      "style='font-size:2px'>AUTHOR\n NAME</tspan></text>"
      "<text freecad:editable='Weight' x='1' y='9'><tspan/></text>"
      "<text><tspan x='1' y='12'>one</tspan><tspan x='1' y='15'>two</tspan></text>");
  ASSERT_EQ(block.texts.size(), 5U);
  EXPECT_EQ(block.texts[0].field, "scale");
  EXPECT_EQ(block.texts[1].field, "author");
  EXPECT_EQ(block.texts[1].text.text, "AUTHOR NAME");
  EXPECT_EQ(block.texts[1].text.at, Vec2(3, 14));
  EXPECT_NEAR(font_size(block.texts[1].text.height), 2, 1e-9);
  EXPECT_EQ(block.texts[2].field, "Weight");
  EXPECT_EQ(block.texts[3].text.text, "one");
  EXPECT_EQ(block.texts[4].text.at, Vec2(1, 5));
  ASSERT_TRUE(block.kept_clear);
  EXPECT_EQ(block.kept_clear->min, Vec2(60, 2));
  EXPECT_EQ(block.kept_clear->max, Vec2(95, 15));
}

TEST_F(TitleBlockTemplate, HasTheSizeThatTheFileSays) {
  const std::string line = "<path d='M0 0h1' stroke='#000'/>";
  EXPECT_NEAR(read(line, "width='1in' height='2cm' viewBox='0 0 1 1'").size.x, 25.4, 1e-9);
  EXPECT_NEAR(read(line, "width='1in' height='2cm' viewBox='0 0 1 1'").size.y, 20, 1e-9);
  EXPECT_NEAR(read(line, "width='96' height='96'").size.x, 25.4, 1e-9);
  EXPECT_EQ(read(line, "width='100%' height='100%' viewBox='0 0 120 40'").size, Vec2(120, 40));
}

TEST_F(TitleBlockTemplate, NobodyCanDrawEndsInOneLine) {
  EXPECT_THROW(read_title_block(folder_ / "none.svg"), MissingFile);
  EXPECT_THROW(read_title_block(folder_.path()), MissingFile);
  EXPECT_EQ(refusal("<svg/>"),
            "1: <svg>: the template states no size: give it width and height in mm");
  EXPECT_EQ(refusal("<svg width='1mm' height='1mm'/>"),
            "0: the template has neither lines nor texts");
  EXPECT_EQ(refusal("<html/>"), "1: the file is no SVG");
  EXPECT_TRUE(refusal("<svg>\n<g></svg>").starts_with("2: bad XML"));
  EXPECT_TRUE(refusal("\x89PNG\r\n").find("bad XML") != std::string::npos);
  EXPECT_EQ(refusal("<svg width='9' height='9'>\n<text x='a' id='title'/></svg>"),
            "2: <text>: 'a' is no number");
}

}  // namespace
}  // namespace burin
