// Flat colours under the lines, in each format that has areas.
#include <burin/drawing/color.h>

#include "png_options.h"
#include "writing.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace burin {
namespace {

using test::least;
using test::parsed;
using test::written;

/// A square of 60 mm with a hole of 20, red; half of a blue one lies over its right side.
Drawing filled(double opacity = 1) {
  Drawing drawing = parsed(least());
  const auto square = [](double x, double y, double size) {
    return std::vector<Vec2>{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  };
  drawing.areas = {
      {.part = 0, .fill = "#ff0000", .rings = {square(20, 60, 60), square(40, 80, 20)}},
      {.part = 1,
       .face = 3,
       .tone = 0,
       .fill = "#0000ff",
       .opacity = opacity,
       .rings = {square(70, 80, 20)}},
      {.part = 2, .rings = {square(120, 60, 10)}}};
  return drawing;
}

TEST(FilledAreas, OfSvgLieBelowAllLinesWithTheirSource) {
  const std::string svg = written(filled(), "svg");
  EXPECT_NE(
      svg.find("<path class=\"part_0\" fill=\"#ff0000\" stroke=\"#ff0000\" stroke-width=\"0.1\""),
      std::string::npos)
      << svg;
  EXPECT_NE(svg.find("class=\"part_1 tone_0\" fill"), std::string::npos);
  EXPECT_NE(svg.find("data-face=\"3\" data-tone=\"0\""), std::string::npos);
  EXPECT_LT(svg.find("#0000ff"), svg.find("<g id=\"a\""));
  const std::string glass = written(filled(0.25), "svg");
  EXPECT_NE(glass.find("fill=\"#0000ff\" fill-opacity=\"0.25\" data-part=\"1\" data-face"),
            std::string::npos)
      << glass;
}

TEST(FilledAreas, OfDrawingFilesComeBack) {
  const std::string json = written(filled(0.25), "json");
  const Drawing back = parsed(json);
  ASSERT_EQ(back.areas.size(), 3u);
  EXPECT_EQ(back.areas[1].face, 3);
  EXPECT_EQ(back.areas[1].tone, 0);
  EXPECT_EQ(back.areas[1].fill, "#0000ff");
  EXPECT_EQ(back.areas[1].opacity, 0.25);
  EXPECT_EQ(back.areas[2].fill, "");
  EXPECT_EQ(written(back, "json"), json);
}

TEST(FilledAreas, OfPngHaveHolesAndAreSeenThrough) {
  WriteOptions options;
  put(options.formats, PngOptions{.dpi = 25.4});
  const std::string png = written(filled(0.5), "png", options);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  ASSERT_TRUE(png_image_begin_read_from_memory(&image, png.data(), png.size()));
  image.format = PNG_FORMAT_RGB;
  std::vector<png_byte> rgb(PNG_IMAGE_SIZE(image));
  ASSERT_TRUE(png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr));
  using Color = std::vector<int>;
  const auto at = [&](int x, int y) {
    const png_byte* p =
        &rgb[3 * (static_cast<std::size_t>(149 - y) * image.width + static_cast<std::size_t>(x))];
    return Color{p[0], p[1], p[2]};
  };
  EXPECT_EQ(at(30, 70), (Color{255, 0, 0}));
  EXPECT_EQ(at(50, 90), (Color{255, 255, 255})) << "the hole";
  EXPECT_NEAR(at(75, 90)[0], 127, 1) << "blue over red";
  EXPECT_NEAR(at(75, 90)[2], 128, 1);
  EXPECT_NEAR(at(85, 90)[0], 127, 1) << "blue over the paper";
  EXPECT_EQ(at(85, 90)[2], 255);
  EXPECT_EQ(at(125, 65), (Color{255, 255, 255})) << "one without a colour";
}

TEST(FilledAreas, OfEpsAreEvenOddAndMixedWithWhatLiesBeneath) {
  const std::string eps = written(filled(0.5), "eps");
  EXPECT_NE(eps.find("1.0000 0.0000 0.0000 setrgbcolor\n20000 60000 m\n"), std::string::npos)
      << eps;
  EXPECT_NE(eps.find("gsave eofill grestore 100 w s"), std::string::npos);
  // Over the paper, and within that over the red one, which is painted again.
  const std::size_t paper = eps.find("0.5020 0.5020 1.0000 setrgbcolor\n70000 80000 m\n");
  ASSERT_NE(paper, std::string::npos) << eps;
  const std::size_t clip = eps.find("gsave gsave eofill grestore eoclip newpath\n", paper);
  ASSERT_NE(clip, std::string::npos);
  const std::size_t red = eps.find("0.5020 0.0000 0.5020 setrgbcolor\n20000 60000 m\n", clip);
  ASSERT_NE(red, std::string::npos) << eps;
  EXPECT_NE(eps.find("grestore newpath\n", red), std::string::npos);
}

TEST(FilledAreas, OfEpsLeaveNoPathBehind) {
  // A path of glass that stays is filled with what comes next.
  Drawing drawing = filled(0.5);
  drawing.areas.push_back({.part = 2, .fill = "#00ff00", .rings = {{{1, 1}, {5, 1}, {5, 5}}}});
  const std::string eps = written(drawing, "eps");
  const auto next = eps.find("0.0000 1.0000 0.0000 setrgbcolor");
  ASSERT_NE(next, std::string::npos);
  const auto restored = eps.rfind("grestore", next);
  EXPECT_EQ(eps.substr(restored, 16), "grestore newpath") << eps;
}

TEST(FilledAreas, OfEpsThatLieBesideEachOtherArePaintedOnce) {
  Drawing drawing = filled();
  for (Area& area : drawing.areas) area.opacity = 0.5;
  drawing.areas[1].rings = {{{120, 80}, {140, 80}, {140, 100}, {120, 100}}};
  const std::string eps = written(drawing, "eps");
  EXPECT_EQ(eps.find("eoclip"), std::string::npos) << eps;
  // Of many on each other there is an end.
  Drawing deep = filled();
  deep.areas.assign(12, deep.areas[0]);
  for (Area& area : deep.areas) area.opacity = 0.5;
  EXPECT_LT(written(deep, "eps").size(), 1U << 20U);
}

TEST(FilledAreas, OfDxfAreSolidHatchesOnALayerOfTheirOwn) {
  const std::string dxf = written(filled(), "dxf");
  std::size_t hatches = 0;
  for (std::size_t at = dxf.find("\nHATCH\n"); at != std::string::npos;
       at = dxf.find("\nHATCH\n", at + 1)) {
    ++hatches;
  }
  EXPECT_EQ(hatches, 2u);
  EXPECT_NE(dxf.find("\nareas\n"), std::string::npos);
  EXPECT_NE(dxf.find("\nSOLID\n"), std::string::npos);
}

/// The colour numbers of a grey area, from black to white.
std::set<std::string> dxf_colors_of_greys() {
  std::set<std::string> numbers;
  for (int level = 0; level < 256; ++level) {
    Drawing drawing = filled();
    drawing.areas.resize(1);
    const auto grey = static_cast<std::uint8_t>(level);
    drawing.areas[0].fill = to_text(Rgb{grey, grey, grey});
    const std::string dxf = written(drawing, "dxf");
    const std::size_t number = dxf.find("\n62\n", dxf.find("\nHATCH\n")) + 4;
    numbers.insert(dxf.substr(number, dxf.find('\n', number) - number));
  }
  return numbers;
}

TEST(FilledAreas, OfDxfThatAreGreyHaveNoHue) {
  EXPECT_EQ(dxf_colors_of_greys(),
            (std::set<std::string>{"8", "9", "250", "251", "252", "253", "254", "255"}));
}

TEST(FilledAreas, OfSvgTakeTheColoursThatAPageGivesThem) {
  const std::string svg = written(filled(0.25), "svg");
  const std::size_t rules = svg.find("<style>@supports (fill:var(--ink)){\n");
  ASSERT_NE(rules, std::string::npos) << svg;
  EXPECT_LT(rules, svg.find("<g id=\"areas\""));
  EXPECT_NE(
      svg.find(":where(#areas .part_0){fill:var(--part-0,#ff0000);stroke:var(--part-0,#ff0000)}"),
      std::string::npos);
  EXPECT_NE(svg.find(":where(#areas .part_1.tone_0){fill:var(--part-1-tone-0,"
                     "var(--part-1,#0000ff))}"),
            std::string::npos)
      << "what is looked through has no seam";
  EXPECT_EQ(svg.find("--part-2"), std::string::npos);
  WriteOptions options;
  options.svg.id_prefix = "fig1-";
  EXPECT_NE(written(filled(), "svg", options).find(":where(#fig1-areas .part_0)"),
            std::string::npos);
  EXPECT_EQ(written(parsed(least()), "svg").find("<style>"), std::string::npos);
}

TEST(FilledAreas, OfSvgHaveTheRulesOfTonesAfterThoseOfParts) {
  Drawing drawing = filled();
  drawing.areas[0].tone = 1;
  drawing.areas[1] = {
      .part = 0, .fill = "#00ff00", .role = "legend", .rings = {{{0, 0}, {1, 0}, {1, 1}}}};
  const std::string svg = written(drawing, "svg");
  const std::size_t of_part = svg.find(":where(#areas .part_0){fill:var(--part-0,#00ff00)"),
                    of_tone = svg.find(":where(#areas .part_0.tone_1){fill:var(--part-0-tone-1,");
  ASSERT_NE(of_part, std::string::npos);
  ASSERT_NE(of_tone, std::string::npos);
  EXPECT_LT(of_part, of_tone) << "the later of two rules holds";
}

/// The same with the first area in half of a spot ink.
Drawing inked() {
  Drawing drawing = filled();
  drawing.areas[0].ink = "Burin Red";
  drawing.areas[0].tint = 0.5;
  drawing.inks = {{"Burin Red", "#ff0000"}};
  return drawing;
}

TEST(FilledAreas, OfSpotInksComeBackFromDrawingFiles) {
  const std::string json = written(inked(), "json");
  const Drawing back = parsed(json);
  EXPECT_EQ(back.inks, inked().inks);
  EXPECT_EQ(back.areas.at(0).ink, "Burin Red");
  EXPECT_EQ(back.areas.at(0).tint, 0.5);
  EXPECT_EQ(written(back, "json"), json);
}

TEST(FilledAreas, OfInksThatMeanNothingAreRefused) {
  const std::string json = written(inked(), "json");
  const auto refused = [&](const std::string& part, const std::string& by) {
    std::string text = json;
    text.replace(text.find(part), part.size(), by);
    return test::refusal(text);
  };
  const auto expect = [&](const std::string& part, const std::string& by, const std::string& said) {
    EXPECT_NE(refused(part, by).find(said), std::string::npos) << by << ": " << refused(part, by);
  };
  const std::string tint = "\"tint\": 0.5", of_area = "\"ink\": \"Burin Red\"",
                    of_list = "\"name\": \"Burin Red\"", color = "\"color\": \"#ff0000\"}]";
  expect(tint, "\"tint\": -0.5", "areas[0].tint: takes a share of an ink, from 0 to 1");
  expect(tint, "\"tint\": 1.5", "from 0 to 1");
  EXPECT_NE(refused(tint, "\"tint\": 1e999"), "");
  EXPECT_NE(refused(tint, "\"tint\": NaN"), "");
  expect(tint, "\"tint\": \"half\"", "areas[0].tint");
  expect(of_area, "\"ink\": \"Blue\"",
         "areas[0].ink: 'Blue' is an ink that the drawing does not list");
  expect(of_area, "\"ink\": \"\"", "areas[0].ink: takes the name of an ink, not nothing");
  expect(of_list, "\"name\": \"" + std::string(10000, 'x') + '"',
         "inks[0].name: takes a name of 127 bytes at most, not 10000");
  expect(of_list, "\"name\": \"All\"", "inks[0].name");
  expect(of_list, "\"name\": \"a\\u0000b\"", "without control characters");
  expect(of_list, "\"nam\": \"Burin Red\"", "inks[0]: lacks \"name\"");
  expect(color, "\"color\": \"rot\"}]", "inks[0].color: takes a colour #rrggbb");
  expect(color, "\"color\": \"#ff0000\"}, {\"name\": \"Burin Red\", \"color\": \"#00ff00\"}]",
         "inks[1].name: is 'Burin Red', as that of another ink");
  expect(color, "\"color\": \"#ff0000\"}, 7]", "inks[1]: takes an object");
}

/// The operators of the one page of a PDF.
std::string page_of(const std::string& pdf) {
  const std::string_view begin = "stream\n", length = "/Length ";
  const std::size_t size = std::stoul(pdf.substr(pdf.find(length) + length.size()));
  const std::string packed = pdf.substr(pdf.find(begin) + begin.size(), size);
  std::string out(1 << 20, '\0');
  uLongf n = out.size();
  EXPECT_EQ(uncompress(reinterpret_cast<Bytef*>(out.data()), &n,
                       reinterpret_cast<const Bytef*>(packed.data()), packed.size()),
            Z_OK);
  out.resize(n);
  return out;
}

/// How often a PDF of that drawing says so.
std::size_t count_in_pdf(const Drawing& drawing, std::string_view what) {
  const std::string pdf = page_of(written(drawing, "pdf"));
  std::size_t n = 0;
  for (std::size_t at = pdf.find(what); at != std::string::npos; at = pdf.find(what, at + 1)) ++n;
  return n;
}

TEST(FilledAreas, OfGreyAreTintsOfBlackBesideSpotInks) {
  Drawing drawing = inked();
  drawing.areas[1].fill = "#999999";
  EXPECT_EQ(count_in_pdf(drawing, "0 0 0 0.4 k"), 1u);
}

TEST(FilledAreas, LinesInTheColourOfASpotInkAreInIt) {
  Drawing drawing = inked();
  Path& line = drawing.layers.front().paths.front();
  line.kind = LineClass::Pattern;
  line.source.part = 0;
  EXPECT_EQ(count_in_pdf(drawing, "/I0 cs 1 scn"), 0u);
  line.color = "#ff0000";
  EXPECT_EQ(count_in_pdf(drawing, "/I0 cs 1 scn"), 1u) << "all of the ink";
  // Of two inks of one colour that of its part; a grey ink is one for hatching alone.
  drawing.inks.insert(drawing.inks.begin(), {"Other", "#ff0000"});
  EXPECT_EQ(count_in_pdf(drawing, "/I1 cs 1 scn"), 1u);
  line.source.part = 7;
  EXPECT_EQ(count_in_pdf(drawing, "/I0 cs 1 scn"), 1u);
  drawing.inks[0].color = line.color = "#8c8c8c";
  EXPECT_EQ(count_in_pdf(drawing, "/I0 cs 1 scn"), 1u);
  line.kind = LineClass::Contour;
  EXPECT_EQ(count_in_pdf(drawing, "/I0 cs 1 scn"), 0u) << "black lines print over all";
}

TEST(FilledAreas, OfSpotInksAreSeparationsInPdf) {
  const std::string pdf = written(inked(), "pdf");
  EXPECT_NE(pdf.find("/I0 [/Separation /Burin#20Red /DeviceRGB"), std::string::npos);
  EXPECT_NE(pdf.find("/Over << /OP true /op true /OPM 1 >>"), std::string::npos);
  EXPECT_EQ(written(filled(), "pdf").find("/Separation"), std::string::npos);
  EXPECT_EQ(pdf, written(inked(), "pdf")) << "the same bytes";
  // Each place of the table is where an object begins.
  const std::size_t table = std::stoul(pdf.substr(pdf.find("startxref\n") + 10));
  ASSERT_EQ(pdf.substr(table, 5), "xref\n");
  std::size_t at = pdf.find(" f \n", table) + 4;
  std::size_t number = 0;
  for (; pdf[at] != 't'; at += 20) {
    const std::size_t place = std::stoul(pdf.substr(at, 10));
    const std::string begin = std::to_string(++number) + " 0 obj\n";
    EXPECT_EQ(pdf.substr(place, begin.size()), begin);
  }
  EXPECT_EQ(number, 6u);
}

TEST(FilledAreas, OfPdfAreFilledByTheEvenOddRule) {
  const std::string pdf = written(filled(), "pdf");
  EXPECT_GT(pdf.size(), written(parsed(least()), "pdf").size());
}

}  // namespace
}  // namespace burin
