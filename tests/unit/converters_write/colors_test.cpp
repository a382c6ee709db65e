// Ink and paper of other colours than black and white, in each format that has colours.
#include "hpgl_options.h"
#include "png_options.h"
#include "writing.h"

#include <png.h>

#include <string>
#include <vector>

namespace burin {
namespace {

using test::least;
using test::parsed;
using test::refusal;
using test::written;

Drawing blue() {
  Drawing drawing = parsed(least());
  drawing.ink_color = "#ffeecc";
  drawing.paper_color = "#123456";
  drawing.layers[0].paths[0].width = {2};
  return drawing;
}

TEST(Colors, OfSvgAreThoseOfAllItsPathsOverASheet) {
  for (const bool merge : {false, true}) {
    WriteOptions options;
    options.svg.merge = merge;
    const std::string svg = written(blue(), "svg", options);
    EXPECT_NE(svg.find("<rect class=\"paper\" width=\"200\" height=\"150\" fill=\"#123456\"/>"),
              std::string::npos)
        << svg;
    EXPECT_NE(svg.find("stroke=\"#ffeecc\""), std::string::npos);
    EXPECT_EQ(svg.find("#000"), std::string::npos);
  }
  const std::string plain = written(parsed(least()), "svg");
  EXPECT_EQ(plain.find("<rect"), std::string::npos);
  EXPECT_NE(plain.find("stroke=\"#000\""), std::string::npos);
}

TEST(Colors, OfDrawingFilesComeBack) {
  const std::string json = written(blue(), "json");
  const Drawing back = parsed(json);
  EXPECT_EQ(back.ink_color, "#ffeecc");
  EXPECT_EQ(back.paper_color, "#123456");
  EXPECT_EQ(written(parsed(least()), "json").find("color"), std::string::npos);
  std::string bad = json;
  bad.replace(bad.find("#123456"), 7, "#12345g");
  EXPECT_NE(refusal(bad).find("takes a colour #rrggbb"), std::string::npos);
}

TEST(Colors, OfEpsAreSetOnce) {
  const std::string eps = written(blue(), "eps");
  EXPECT_NE(eps.find("0.0706 0.2039 0.3373 setrgbcolor 0 0 "), std::string::npos);
  EXPECT_NE(eps.find("1.0000 0.9333 0.8000 setrgbcolor 1 setlinecap"), std::string::npos);
  EXPECT_NE(written(parsed(least()), "eps").find("0 setgray 1 setlinecap"), std::string::npos);
}

struct Pixels {
  png_image image{};
  std::vector<png_byte> rgba;
};
Pixels pixels_of(const std::string& png) {
  Pixels p;
  p.image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&p.image, png.data(), png.size()));
  p.image.format = PNG_FORMAT_RGBA;
  p.rgba.resize(PNG_IMAGE_SIZE(p.image));
  EXPECT_TRUE(png_image_finish_read(&p.image, nullptr, p.rgba.data(), 0, nullptr));
  return p;
}

TEST(Colors, OfPngAreThoseOfThePaperAndOfTheInk) {
  for (const bool transparent : {false, true}) {
    WriteOptions options;
    using enum PngOptions::Background;
    put(options.formats, PngOptions{.dpi = 60, .background = transparent ? Transparent : White});
    const Pixels p = pixels_of(written(blue(), "png", options));
    // The line runs from the lower left corner to (100, 50) of 200 x 150 mm.
    const auto at = [&](double x, double y) {
      const auto column = static_cast<std::size_t>(x / 200 * p.image.width),
                 row = static_cast<std::size_t>((1 - y / 150) * p.image.height);
      const png_byte* pixel = p.rgba.data() + 4 * (row * p.image.width + column);
      return std::vector<int>(pixel, pixel + 4);
    };
    EXPECT_EQ(at(50, 25), (std::vector<int>{0xff, 0xee, 0xcc, 255}));
    const std::vector<int> paper = at(150, 100);
    if (transparent) {
      EXPECT_EQ(paper[3], 0);
    } else {
      EXPECT_EQ(paper, (std::vector<int>{0x12, 0x34, 0x56, 255}));
    }
  }
}

/// A red dashed layer and one in the drawing's ink.
Drawing two_colors() {
  Drawing drawing = parsed(least());
  drawing.layers[0].paths[0].width = {2};
  Layer red = drawing.layers[0];
  red.name = "red";
  red.color = "#d00000";
  red.dashes = {3, 1.5};
  red.paths[0].points = {{0, 100}, {200, 100}};
  red.texts.push_back({{20, 120}, 10, TextAnchor::Start, "I", "note", 0});
  drawing.layers.push_back(red);
  return drawing;
}

TEST(Colors, OfLayersAreInEachFormat) {
  const Drawing drawing = two_colors();
  for (const bool merge : {false, true}) {
    WriteOptions options;
    options.svg.merge = merge;
    const std::string svg = written(drawing, "svg", options);
    EXPECT_NE(svg.find("stroke=\"#d00000\" stroke-linecap=\"round\" stroke-linejoin=\"round\" "
                       "stroke-dasharray=\"3 1.5\""),
              std::string::npos);
    EXPECT_NE(svg.find("stroke=\"#000\""), std::string::npos);
    EXPECT_NE(svg.find("fill=\"#d00000\" stroke=\"none\">I</text>"), std::string::npos);
  }
  const std::string eps = written(drawing, "eps");
  EXPECT_NE(eps.find("% layer red\n0.8157 0.0000 0.0000 setrgbcolor\n[3000 1500] 0 setdash"),
            std::string::npos);
  // The layer "red" is red (1) and dashed, "a" as the program that shows it has it.
  const std::string dxf = written(drawing, "dxf");
  EXPECT_NE(dxf.find("2\nred\n70\n0\n62\n1\n6\nACAD_ISO02W100\n"), std::string::npos);
  EXPECT_NE(dxf.find("2\na\n70\n0\n62\n7\n6\nContinuous\n"), std::string::npos);
  const Drawing back = parsed(written(drawing, "json"));
  EXPECT_EQ(back.layers[1].color, "#d00000");
  EXPECT_EQ(back.layers[1].dashes, (std::vector<double>{3, 1.5}));
  EXPECT_EQ(back.layers[0].color, "");
  EXPECT_EQ(written(back, "json"), written(drawing, "json"));
  EXPECT_NE(written(drawing, "pdf"), written(parsed(least()), "pdf"));
}

TEST(Colors, OfLayersAreInPictures) {
  for (const bool transparent : {false, true}) {
    for (const bool on_paper : {false, true}) {
      Drawing drawing = two_colors();
      if (on_paper) drawing.paper_color = "#123456";
      WriteOptions options;
      using enum PngOptions::Background;
      put(options.formats, PngOptions{.dpi = 60, .background = transparent ? Transparent : White});
      const Pixels p = pixels_of(written(drawing, "png", options));
      const auto at = [&](double x, double y) {
        const auto column = static_cast<std::size_t>(x / 200 * p.image.width),
                   row = static_cast<std::size_t>((1 - y / 150) * p.image.height);
        const png_byte* pixel = p.rgba.data() + 4 * (row * p.image.width + column);
        return std::vector<int>(pixel, pixel + 4);
      };
      EXPECT_EQ(at(1.5, 100), (std::vector<int>{0xd0, 0, 0, 255}));
      EXPECT_EQ(at(50, 25), (std::vector<int>{0, 0, 0, 255}));
      const std::vector<int> paper = at(150, 140);
      if (transparent) {
        EXPECT_EQ(paper[3], 0);
      } else {
        EXPECT_EQ(paper, on_paper ? (std::vector<int>{0x12, 0x34, 0x56, 255})
                                  : (std::vector<int>{255, 255, 255, 255}));
      }
    }
  }
}

TEST(Colors, OfLayersAreRefusedWhereTheyAreNone) {
  const auto layer = [](const std::string& more) {
    std::string text = least();
    text.replace(text.find("\"name\": \"a\""), 11, "\"name\": \"a\", " + more);
    return text;
  };
  EXPECT_NE(refusal(layer("\"color\": \"red\"")).find("layers[0].color: takes a colour #rrggbb"),
            std::string::npos);
  for (const char* dashes : {"[1]", "[0, 0]", "[1, -1]", "[1, 2, 3]"}) {
    EXPECT_NE(refusal(layer(std::string("\"dashes\": ") + dashes)), "") << dashes;
  }
  EXPECT_EQ(refusal(layer("\"dashes\": [1, 2]")), "");
}

/// A line in the drawing's ink and, of another part in the same layer, a red one and its red dot.
Drawing red_part() {
  Drawing drawing = parsed(least());
  drawing.layers[0].paths[0].width = {2};
  Path red = drawing.layers[0].paths[0];
  red.source.part = 7;
  red.color = "#d00000";
  red.points = {{0, 100}, {200, 100}};
  drawing.layers[0].paths.push_back(red);
  return drawing;
}

TEST(Colors, OfLinesAreInEachFormat) {
  const Drawing drawing = red_part();
  const std::string svg = written(drawing, "svg");
  // Once, on the group of the part.
  EXPECT_NE(svg.find("data-part=\"7\" stroke=\"#d00000\""), std::string::npos) << svg;
  EXPECT_EQ(svg.find("#d00000", svg.find("#d00000") + 1), std::string::npos);
  for (const LineOrder order : {LineOrder::Drawing, LineOrder::Travel}) {
    WriteOptions options;
    options.svg.order = order;
    options.svg.merge = order == LineOrder::Drawing;
    const std::string other = written(drawing, "svg", options);
    EXPECT_NE(other.find("stroke=\"#d00000\" stroke-width=\"2\""), std::string::npos) << other;
    EXPECT_NE(other.find("stroke=\"#000\""), std::string::npos);
  }
  const std::string eps = written(drawing, "eps");
  EXPECT_LT(eps.find("0 setgray"), eps.find("0.8157 0.0000 0.0000 setrgbcolor\n"));
  // The layer is as the program that shows it has it, the red line is red (1).
  const std::string dxf = written(drawing, "dxf");
  EXPECT_NE(dxf.find("2\na\n70\n0\n62\n7\n6\nContinuous\n"), std::string::npos);
  EXPECT_NE(dxf.find("\n8\na\n62\n1\n"), std::string::npos);
  const Drawing back = parsed(written(drawing, "json"));
  EXPECT_EQ(back.layers[0].paths[0].color, "");
  EXPECT_EQ(back.layers[0].paths[1].color, "#d00000");
  EXPECT_EQ(written(back, "json"), written(drawing, "json"));
  EXPECT_NE(written(drawing, "pdf"), written(parsed(least()), "pdf"));
  std::string bad = written(drawing, "json");
  bad.replace(bad.find("#d00000"), 7, "#d0000x");
  EXPECT_NE(refusal(bad).find("layers[0].paths[1].color: takes a colour #rrggbb"),
            std::string::npos);
}

TEST(Colors, OfLinesThatAreAreas) {
  Drawing drawing = red_part();
  Path& red = drawing.layers[0].paths[1];
  red.kind = LineClass::Stroke;
  red.points = {{0, 100}, {100, 100}, {200, 100}};
  red.points3.clear();
  red.width = {1, 3, 1};
  EXPECT_NE(written(drawing, "svg").find("fill=\"#d00000\" stroke=\"none\""), std::string::npos);
  WriteOptions merged;
  merged.svg.merge = true;
  EXPECT_NE(written(drawing, "svg", merged).find("fill=\"#d00000\" stroke=\"none\""),
            std::string::npos);
}

TEST(Colors, OfLinesAreInPictures) {
  WriteOptions options;
  put(options.formats, PngOptions{.dpi = 60});
  const Pixels p = pixels_of(written(red_part(), "png", options));
  const auto at = [&](double x, double y) {
    const auto column = static_cast<std::size_t>(x / 200 * p.image.width),
               row = static_cast<std::size_t>((1 - y / 150) * p.image.height);
    const png_byte* pixel = p.rgba.data() + 4 * (row * p.image.width + column);
    return std::vector<int>(pixel, pixel + 4);
  };
  EXPECT_EQ(at(150, 100), (std::vector<int>{0xd0, 0, 0, 255}));
  EXPECT_EQ(at(50, 25), (std::vector<int>{0, 0, 0, 255}));
}

// Lines of two colours are two lines, even where they meet.
TEST(Colors, OfLinesThatMeetAreKept) {
  Drawing drawing = parsed(least());
  drawing.layers[0].paths[0].points = {{0, 0}, {50, 0}};
  drawing.layers[0].paths[0].width = {0.5};
  Path red = drawing.layers[0].paths[0];
  red.points = {{50, 0}, {100, 0}};
  red.color = "#d00000";
  drawing.layers[0].paths.push_back(red);
  WriteOptions options;
  options.svg.order = LineOrder::Travel;
  const std::string svg = written(drawing, "svg", options);
  EXPECT_NE(svg.find("#d00000"), std::string::npos);
  std::size_t paths = 0;
  for (std::size_t at = svg.find("<path"); at != svg.npos; at = svg.find("<path", at + 1)) ++paths;
  EXPECT_EQ(paths, 2U);
}

TEST(Colors, OfLinesHavePensOfTheirOwn) {
  const auto pens = [](const Drawing& drawing, const std::string& rule) {
    WriteOptions options;
    HpglOptions hpgl_options;
    hpgl_options.pens = rule;
    put(options.formats, hpgl_options);
    const std::string hpgl = written(drawing, "hpgl", options);
    std::string chosen;
    for (std::size_t at = hpgl.find("SP"); at != hpgl.npos; at = hpgl.find("SP", at + 1)) {
      chosen += hpgl[at + 2];
    }
    return chosen;
  };
  EXPECT_EQ(pens(red_part(), "auto"), "120");
  EXPECT_EQ(pens(red_part(), "layers"), "120");
  EXPECT_EQ(pens(red_part(), "one"), "10");
  EXPECT_EQ(pens(red_part(), "a=4"), "40");
  Drawing plain = red_part();
  plain.layers[0].paths[1].color.clear();
  EXPECT_EQ(pens(plain, "auto"), "10");
}

}  // namespace
}  // namespace burin
