#include <burin/base/error.h>
#include <burin/drawing/font.h>
#include <burin/drawing/path_data.h>
#include <burin/drawing/text.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "../turned.h"

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>

namespace burin {
namespace {

/// A letter in units of the font.
struct Glyph {
  double advance = 0;
  FT_UInt index = 0;
  std::vector<std::vector<CubicBezier>> chains;
};

Vec2 vec(const FT_Vector& v) { return {static_cast<double>(v.x), static_cast<double>(v.y)}; }

/// Collects an outline; quadratic curves become cubic ones.
struct Tracer {
  Glyph& glyph;
  Vec2 at{0};

  void add(const CubicBezier& c) {
    glyph.chains.back().push_back(c);
    at = c[3];
  }
  static int move(const FT_Vector* to, void* self) {
    Tracer& t = *static_cast<Tracer*>(self);
    t.glyph.chains.emplace_back();
    t.at = vec(*to);
    return 0;
  }
  static int line(const FT_Vector* to, void* self) {
    Tracer& t = *static_cast<Tracer*>(self);
    const Vec2 p = t.at, q = vec(*to);
    t.add({p, glm::mix(p, q, 1.0 / 3), glm::mix(p, q, 2.0 / 3), q});
    return 0;
  }
  static int conic(const FT_Vector* control, const FT_Vector* to, void* self) {
    Tracer& t = *static_cast<Tracer*>(self);
    const Vec2 p = t.at, c = vec(*control), q = vec(*to);
    t.add({p, glm::mix(p, c, 2.0 / 3), glm::mix(q, c, 2.0 / 3), q});
    return 0;
  }
  static int cubic(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* self) {
    Tracer& t = *static_cast<Tracer*>(self);
    t.add({t.at, vec(*a), vec(*b), vec(*to)});
    return 0;
  }
};

/// FreeType's face is for one thread at a time.
class Font {
 public:
  static Font& get() {
    static Font font;
    return font;
  }

  /// Units of the font: of capitals, and of what programs call the size.
  double capital() const { return capital_; }
  double em() const { return em_; }

  /// Lives as long as the program.
  const Glyph& glyph(char32_t character) {
    const std::lock_guard lock(mutex_);
    const auto [it, is_new] = glyphs_.try_emplace(character);
    if (is_new) load(character, it->second);
    return it->second;
  }

 private:
  Font() {
    const auto bytes = font_file();
    if (FT_Init_FreeType(&library_) != 0 ||
        FT_New_Memory_Face(library_, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &face_) !=
            0) {
      throw Error("FreeType cannot read the font of texts");
    }
    em_ = face_->units_per_EM;
    for (const auto& chain : glyph(U'H').chains) {
      for (const CubicBezier& c : chain) capital_ = std::max(capital_, c[3].y);
    }
  }
  ~Font() {
    FT_Done_Face(face_);
    FT_Done_FreeType(library_);
  }

  void load(char32_t character, Glyph& glyph) {
    glyph.index = FT_Get_Char_Index(face_, character);
    if (FT_Load_Glyph(face_, glyph.index, FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING) != 0) return;
    glyph.advance = static_cast<double>(face_->glyph->metrics.horiAdvance);
    FT_Outline_Funcs calls{&Tracer::move, &Tracer::line, &Tracer::conic, &Tracer::cubic, 0, 0};
    Tracer tracer{glyph};
    FT_Outline_Decompose(&face_->glyph->outline, &calls, &tracer);
    std::erase_if(glyph.chains, [](const auto& chain) { return chain.empty(); });
  }

  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
  double em_ = 1, capital_ = 0;
  std::mutex mutex_;
  std::map<char32_t, Glyph> glyphs_;
};

std::vector<const Glyph*> glyphs_of(std::string_view text) {
  std::vector<const Glyph*> glyphs;
  for (const char32_t c : code_points(text)) glyphs.push_back(&Font::get().glyph(c));
  return glyphs;
}

/// From its place to where it begins, along the text.
double start_of(const Text& text) {
  if (text.anchor == TextAnchor::Start) return 0;
  const double width = text_width(text.text, text.height);
  return (text.anchor == TextAnchor::Middle ? -0.5 : -1) * width;
}

}  // namespace

Vec2 way_of(const Text& text) {
  // Quarter turns are exact, so that their texts are the same on any machine.
  const double quarters = text.turn / 90;
  if (quarters == std::round(quarters)) {
    constexpr std::array<Vec2, 4> kWays{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
    return kWays[static_cast<std::size_t>(std::fmod(std::fmod(quarters, 4) + 4, 4))];
  }
  const double angle = glm::radians(text.turn);
  return {std::cos(angle), std::sin(angle)};
}

double font_size(double height) { return height * Font::get().em() / Font::get().capital(); }

double text_width(std::string_view text, double height) {
  double width = 0;
  for (const Glyph* glyph : glyphs_of(text)) width += glyph->advance;
  return width * height / Font::get().capital();
}

std::size_t missing_glyphs(std::string_view text) {
  std::size_t missing = 0;
  for (const Glyph* glyph : glyphs_of(text)) missing += glyph->index != 0 ? 0 : 1;
  return missing;
}

std::string fitted_text(std::string_view text, double height, double width) {
  if (text_width(text, height) <= width) return std::string(text);
  const std::string dots = "...";
  double room = width - text_width(dots, height);
  std::string kept;
  for (const char32_t c : code_points(text)) {
    const std::string letter = utf8_of(c);
    room -= text_width(letter, height);
    if (room < 0) break;
    kept += letter;
  }
  return kept + dots;
}

std::vector<PlacedLetter> placed_letters(const Text& text) {
  std::vector<PlacedLetter> letters;
  const double scale = text.height / Font::get().capital();
  const Vec2 way = way_of(text);
  Vec2 at = text.at + start_of(text) * way;
  for (const char32_t c : code_points(text.text)) {
    const Glyph& glyph = Font::get().glyph(c);
    letters.push_back({c, glyph.index, at, scale * glyph.advance});
    at += scale * glyph.advance * way;
  }
  return letters;
}

Ink text_ink(const Text& text) {
  Ink ink;
  ink.filled = true;
  const double scale = text.height / Font::get().capital();
  const Vec2 right = scale * way_of(text), up = turned_left(right);
  for (const PlacedLetter& letter : placed_letters(text)) {
    for (const auto& chain : Font::get().glyph(letter.character).chains) {
      auto& out = ink.chains.emplace_back();
      const auto placed = [&](Vec2 p) { return letter.at + p.x * right + p.y * up; };
      for (const CubicBezier& c : chain) {
        out.push_back({placed(c[0]), placed(c[1]), placed(c[2]), placed(c[3])});
      }
    }
  }
  return ink;
}

std::vector<std::vector<Vec2>> text_outlines(const Text& text, double tolerance) {
  std::vector<std::vector<Vec2>> outlines;
  for (auto& chain : text_ink(text).chains) {
    outlines.push_back(flattened(Subpath{std::move(chain), true}, tolerance));
  }
  return outlines;
}

Box2 text_box(const Text& text) {
  constexpr double kTail = 0.35;
  const double from = start_of(text), to = from + text_width(text.text, text.height);
  const Vec2 right = way_of(text), up = turned_left(right);
  Box2 box;
  for (const double x : {from, to}) {
    for (const double y : {-kTail * text.height, (1 + kTail) * text.height})
      box.add(text.at + x * right + y * up);
  }
  return box;
}

}  // namespace burin
