#include "pdf_letters.h"

#include <burin/drawing/font.h>

#include "shapes.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

constexpr std::size_t kInFont = 256;  // codes are bytes
constexpr double kUnits = 1000;       // a size of the font

/// A letter alone, in units of its font.
Text alone(char32_t character) {
  return {Vec2(0), kUnits / font_size(1), TextAnchor::Start, utf8_of(character), {}, 0, 0};
}

void point(Buffer& out, Vec2 p) {
  append_fixed(out, p.x, kPdfDecimals);
  append(out, " ");
  append_fixed(out, p.y, kPdfDecimals);
  append(out, " ");
}

/// How a letter is painted, in the ink of the text ("d1").
std::string glyph(const Text& letter, double advance) {
  const Ink ink = text_ink(letter);
  Box2 box;
  for (const auto& chain : ink.chains) {
    for (const CubicBezier& c : chain) {
      for (const Vec2& p : c) box.add(p);
    }
  }
  if (box.empty()) box.add(Vec2(0));
  Buffer out;
  append_fixed(out, advance, kPdfDecimals);
  append(out, " 0 ");
  point(out, box.min);
  point(out, box.max);
  append(out, "d1\n");
  for (const auto& chain : ink.chains) {
    point(out, chain.front()[0]);
    append(out, "m\n");
    for (const CubicBezier& c : chain) {
      const bool straight = is_straight(c, kStraight);
      if (!straight) point(out, c[1]), point(out, c[2]);
      point(out, c[3]);
      append(out, straight ? "l\n" : "c\n");
    }
    append(out, "h\n");
  }
  if (!ink.chains.empty()) append(out, "f\n");
  return fmt::to_string(out);
}

/// Which character each code of a font stands for, for programs that find and copy.
std::string to_unicode(std::span<const char32_t> characters) {
  std::string out =
      "/CIDInit /ProcSet findresource begin 12 dict begin begincmap\n/CIDSystemInfo << /Registry "
      "(Adobe) /Ordering (UCS) /Supplement 0 >> def\n/CMapName /Adobe-Identity-UCS def /CMapType 2 "
      "def\n1 begincodespacerange <00> <FF> endcodespacerange\n";
  constexpr std::size_t kMost = 100;  // of one list
  for (std::size_t first = 0; first < characters.size(); first += kMost) {
    const std::size_t n = std::min(kMost, characters.size() - first);
    out += fmt::format("{} beginbfchar\n", n);
    for (std::size_t i = first; i < first + n; ++i) {
      out += fmt::format("<{:02X}> <{}>\n", i, utf16_hex(utf8_of(characters[i])));
    }
    out += "endbfchar\n";
  }
  return out + "endcmap CMapName currentdict /CMap defineresource pop end end\n";
}

}  // namespace

std::size_t PdfLetters::place(char32_t character) {
  const auto [it, is_new] = places_.try_emplace(character, characters_.size());
  if (is_new) characters_.push_back(character);
  return it->second;
}

void PdfLetters::show(const Text& text, Buffer& out) {
  append(out, "BT\n");
  const std::vector<PlacedLetter> letters = placed_letters(text);
  const Vec2 way = way_of(text);
  for (std::size_t i = 0, end = 0; i < letters.size(); i = end) {
    const std::size_t font = place(letters[i].character) / kInFont;
    std::string codes;
    for (; end < letters.size(); ++end) {
      const std::size_t at = place(letters[end].character);
      if (at / kInFont != font) break;
      codes += fmt::format("{:02X}", at % kInFont);
    }
    append(out, fmt::format("/F{} {:.6f} Tf {:.6g} {:.6g} {:.6g} {:.6g} ", font,
                            font_size(text.height), way.x, way.y, 0 - way.y, way.x));
    point(out, letters[i].at);
    append(out, fmt::format("Tm <{}> Tj\n", codes));
  }
  append(out, "ET\n");
}

std::size_t PdfLetters::write_font(std::size_t font, PdfObjects& file) const {
  const std::size_t first = font * kInFont;
  const auto characters =
      std::span(characters_).subspan(first, std::min(kInFont, characters_.size() - first));
  std::string glyphs, names, widths;
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const Text letter = alone(characters[i]);
    const double advance = text_width(letter.text, letter.height);
    const std::size_t object = file.reserve();
    file.write_stream(object, glyph(letter, advance));
    glyphs += fmt::format(" /g{} {} 0 R", i, object);
    names += fmt::format(" /g{}", i);
    widths += fmt::format(" {:.3f}", advance);
  }
  const std::size_t unicode = file.reserve(), object = file.reserve();
  file.write_stream(unicode, to_unicode(characters));
  // A box of zeros leaves it to the letters, which say theirs.
  file.write(object,
             fmt::format("<< /Type /Font /Subtype /Type3 /FontBBox [0 0 0 0] /FontMatrix [{0} 0 0 "
                         "{0} 0 0] /CharProcs <<{1} >> /Encoding << /Type /Encoding /Differences "
                         "[0{2}] >> /FirstChar 0 /LastChar {3} /Widths [{4} ] /Resources << >> "
                         "/ToUnicode {5} 0 R >>",
                         1 / kUnits, glyphs, names, characters.size() - 1, widths, unicode));
  return object;
}

std::string PdfLetters::write(PdfObjects& file) const {
  std::string out = "<<";
  for (std::size_t font = 0; font * kInFont < characters_.size(); ++font) {
    out += fmt::format(" /F{} {} 0 R", font, write_font(font, file));
  }
  return out + " >>";
}

}  // namespace burin
