#pragma once
/// The font of texts: osifont, letters after ISO 3098, which is a part of the library (GPL with the
/// font exception; Burin is GPL), so that no font need be installed and lengths are known.

#include <burin/base/box.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/ink.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// What programs that have it installed know it by.
inline constexpr std::string_view kFontFamily = "osifont";

/// Paper mm that programs call the size of a font whose capital letters have a height in mm.
double font_size(double height);

/// Paper mm from the first letter to the last, of capital letters of that height. Characters that
/// the font has not are as wide as the box that stands for them.
double text_width(std::string_view text, double height);

/// How many characters of a text the font has not; outlines of it have a box for each.
std::size_t missing_glyphs(std::string_view text);

/// The text cut at the end, with "...", so that it is no wider; itself where it is not.
std::string fitted_text(std::string_view text, double height, double width);

/// The font as a TrueType file, for formats that carry fonts. Lives as long as the program.
std::span<const unsigned char> font_file();

struct PlacedLetter {
  char32_t character = 0;
  /// Its number in `font_file`; 0: the box of characters that the font has not.
  std::uint32_t glyph = 0;
  /// Paper mm: where it begins on the base line, and how far the next begins from there.
  Vec2 at{0};
  double advance = 0;
};

/// The characters of a text where `text_ink` has their outlines, for formats with fonts. Safe from
/// many threads.
std::vector<PlacedLetter> placed_letters(const Text& text);

/// The outlines of a text, filled by the nonzero rule, for formats that have no text of their own.
/// Safe from many threads. Cost: about a microsecond a letter.
Ink text_ink(const Text& text);

/// The same as closed polylines within `tolerance` mm, for pens.
std::vector<std::vector<Vec2>> text_outlines(const Text& text, double tolerance);

/// The way that a text runs on the sheet, unit.
Vec2 way_of(const Text& text);

/// The box of a text's letters, paper mm: from the base line to the height of capitals, and as much
/// again below as tails of letters need. Of a turned text the box about that.
Box2 text_box(const Text& text);

}  // namespace burin
