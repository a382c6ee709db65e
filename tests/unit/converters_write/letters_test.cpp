// Texts in PDF: found, copied, and where the outlines of other formats are.
#include <burin/drawing/text.h>

#include "png_options.h"
#include "writing.h"

#include <burin_test/folder.h>
#include <burin_test/pictures.h>
#include <fmt/format.h>

#include <cstddef>
#include <numeric>
#include <string>

namespace burin {
namespace {

using test::least;
using test::parsed;
using test::written;

/// A sheet with texts alone; in spot inks where `inks` says so, which another writer does.
Drawing lettered(bool inks) {
  Drawing drawing = parsed(least());
  Layer& layer = drawing.layers.front();
  layer.paths.clear();
  layer.texts = {
      {{20, 120}, 7, TextAnchor::Start, "Geh\xC3\xA4use (M6)", "parts_list", 1},
      {{100, 80}, 3.5, TextAnchor::Middle, "\xD0\x9D\xD0\xB0\xD1\x81\xD0\xBE\xD1\x81", "note"},
      {{190, 40}, 5, TextAnchor::End, "\xE6\xBC\xA2\xE5\xAD\x97 A", "note"},
  };
  if (inks) drawing.inks = {{"Burin Red", "#ff0000"}};
  return drawing;
}

class PdfLetters : public testing::TestWithParam<bool> {
 protected:
  /// What pdftotext finds in a drawing.
  std::string found(const Drawing& drawing) const {
    const std::string file = folder_.write("a.pdf", written(drawing, "pdf"));
    const std::string text = folder_ / "a.txt";
    EXPECT_TRUE(test::shell(fmt::format("pdftotext -layout {} {}", file, text)));
    return test::slurp(text);
  }

  const test::Folder folder_;
};

TEST_P(PdfLetters, AreFoundAndCopied) {
  if (!test::has_program("pdftotext")) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  const std::string text = found(lettered(GetParam()));
  for (const char* word : {"Geh\xC3\xA4use (M6)", "\xD0\x9D\xD0\xB0\xD1\x81\xD0\xBE\xD1\x81",
                           "\xE6\xBC\xA2\xE5\xAD\x97 A"}) {
    EXPECT_NE(text.find(word), text.npos) << word << " in\n" << text;
  }
  EXPECT_EQ(written(lettered(GetParam()), "pdf"), written(lettered(GetParam()), "pdf"));
}

TEST_P(PdfLetters, StandWhereOutlinesDo) {
  if (!test::has_program("pdftoppm")) GTEST_SKIP() << "pdftoppm (poppler-utils) is not installed";
  const std::string file = folder_.write("a.pdf", written(lettered(GetParam()), "pdf"));
  ASSERT_TRUE(test::shell(
      fmt::format("pdftoppm -r 254 -gray -png -singlefile {} {}", file, folder_ / "pdf")));
  WriteOptions options;
  put(options.formats, PngOptions{.dpi = 254});
  const test::Picture pdf = test::read_png(folder_ / "pdf.png");
  const test::Picture png =
      test::read_png(folder_.write("b.png", written(lettered(GetParam()), "png", options)));
  // pdftoppm rounds the sheet up.
  ASSERT_LE(pdf.width - png.width, 1u);
  ASSERT_LE(pdf.height - png.height, 1u);
  const auto ink = [](const test::Picture& p) {
    return 255.0 * static_cast<double>(p.pixels.size()) -
           std::accumulate(p.pixels.begin(), p.pixels.end(), 0.0);
  };
  EXPECT_NEAR(ink(pdf), ink(png), 0.03 * ink(png));
  // pdftoppm sets letters on quarters of a pixel (0.025 mm) in lines that are 5 wide; letters
  // elsewhere would differ by twice their ink.
  EXPECT_LT(255.0 * static_cast<double>(png.pixels.size()) * mean_difference(pdf, png),
            0.3 * ink(png));
}

TEST_P(PdfLetters, MayBeMoreThanOneFontHolds) {
  if (!test::has_program("pdftotext")) GTEST_SKIP() << "pdftotext (poppler-utils) is not installed";
  Drawing drawing = lettered(GetParam());
  drawing.layers.front().texts.clear();
  constexpr char32_t kFirst = 0xC0, kEnd = 0x250;  // Latin letters with accents: 400
  for (char32_t first = kFirst; first < kEnd; first += 20) {
    std::string row = "r";
    for (char32_t c = first; c < first + 20; ++c) row += utf8_of(c);
    const double y = 145 - 0.3 * static_cast<double>(first - kFirst);
    drawing.layers.front().texts.push_back({{10, y}, 3, TextAnchor::Start, row, "note"});
  }
  const std::string text = found(drawing);
  for (const Text& row : drawing.layers.front().texts) {
    EXPECT_NE(text.find(row.text), text.npos) << row.text;
  }
}

INSTANTIATE_TEST_SUITE_P(WithAndWithoutSpotInks, PdfLetters, testing::Bool());

}  // namespace
}  // namespace burin
