// Ink and paper of other colours than black and white, in each format that has colours.
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
    options.png.dpi = 60;
    if (transparent) options.png.background = PngOptions::Background::Transparent;
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

}  // namespace
}  // namespace burin
