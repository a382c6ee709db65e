#include "lettering.h"

#include <burin/base/error.h>

#include "at_node.h"
#include "clip.h"
#include "fonts.h"
#include "fragments.h"
#include "text.h"

#include FT_GLYPH_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_IDS_H

#include <hb-ft.h>
#include <hb.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace burin::csg {
namespace {

// OpenSCAD's: glyphs are taken at so many 64ths of a point and 100 dots an inch; the size of a text
// is 1000/1024 of what that would make.
constexpr double kScale = 1e5;
constexpr double kUnscale = 1 / 1.024e5;
constexpr int kDots = 100;
// A text that long fills hours; a curve of more pieces is no curve that anyone has drawn.
constexpr std::size_t kMostBytes = 1'000'000;
constexpr int kMostPieces = 10'000;

struct Style {
  double size = 10, spacing = 1;
  int pieces = 2;  // of a curve
  std::string text, font, direction, language, script, halign, valign;
};

Style style_of(const Node& node) {
  Style s;
  s.size = node.number("size", s.size);
  s.spacing = node.number("spacing", s.spacing);
  if (!std::isfinite(s.size) || !std::isfinite(s.spacing)) {
    throw InputError("text() with a size or spacing that is no finite number");
  }
  // A part of a circle's corners each: most curves of fonts are short.
  s.pieces = std::max(fragments(s.size, fineness_of(node)) / 8 + 1, 2);
  if (s.pieces > kMostPieces) {
    throw InputError(
        fmt::format("text() with {} pieces a curve; set $fn, $fa or $fs to less, e.g. "
                    "$fn = 100",
                    s.pieces));
  }
  s.text = node.text("text");
  if (s.text.size() > kMostBytes) throw InputError("text() of more than a million bytes");
  s.font = node.text("font");
  s.direction = node.text("direction");
  s.language = node.text("language");
  s.script = node.text("script");
  s.halign = node.text("halign");
  s.valign = node.text("valign");
  return s;
}

/// Points of a glyph's outline, in units of kScale.
class Pen {
 public:
  Pen(double size, int pieces) : size_(size), pieces_(pieces) {}

  Vec2 offset{0};
  Region glyph;

  void move(Vec2 to) {
    end();
    add(to);
    at_ = to;
  }
  void line(Vec2 to) {
    add(to);
    at_ = to;
  }
  void curve(Vec2 b, Vec2 c) {
    for (int i = 1; i <= pieces_; ++i) {
      const double t = static_cast<double>(i) / pieces_, s = 1 - t;
      add(s * s * at_ + 2 * s * t * b + t * t * c);
    }
    at_ = c;
  }
  void curve(Vec2 b, Vec2 c, Vec2 d) {
    for (int i = 1; i <= pieces_; ++i) {
      const double t = static_cast<double>(i) / pieces_, s = 1 - t;
      add(s * s * s * at_ + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d);
    }
    at_ = d;
  }
  void end() {
    if (outline_.points.size() >= 3) {
      outline_.arc.assign(outline_.points.size(), -1);
      glyph.outlines.push_back(std::move(outline_));
    }
    outline_ = {};
  }

 private:
  void add(Vec2 p) { outline_.points.push_back(size_ * (p + offset)); }

  double size_;
  int pieces_;
  Vec2 at_{0};
  Outline outline_;
};

Vec2 outline_point(const FT_Vector* v) {
  return Vec2(static_cast<double>(v->x), static_cast<double>(v->y)) / kScale;
}

/// FreeType walks an outline with functions of C.
void decompose(FT_Outline& outline, Pen& pen) {
  FT_Outline_Funcs functions{};
  functions.move_to = [](const FT_Vector* to, void* p) {
    static_cast<Pen*>(p)->move(outline_point(to));
    return 0;
  };
  functions.line_to = [](const FT_Vector* to, void* p) {
    static_cast<Pen*>(p)->line(outline_point(to));
    return 0;
  };
  functions.conic_to = [](const FT_Vector* b, const FT_Vector* to, void* p) {
    static_cast<Pen*>(p)->curve(outline_point(b), outline_point(to));
    return 0;
  };
  functions.cubic_to = [](const FT_Vector* b, const FT_Vector* c, const FT_Vector* to, void* p) {
    static_cast<Pen*>(p)->curve(outline_point(b), outline_point(c), outline_point(to));
    return 0;
  };
  FT_Outline_Decompose(&outline, &functions, &pen);
  pen.end();
}

struct DoneGlyph {
  void operator()(FT_Glyph glyph) const { FT_Done_Glyph(glyph); }
};
struct DestroyFont {
  void operator()(hb_font_t* font) const { hb_font_destroy(font); }
};
struct DestroyBuffer {
  void operator()(hb_buffer_t* buffer) const { hb_buffer_destroy(buffer); }
};

struct Placed {
  std::unique_ptr<FT_GlyphRec, DoneGlyph> glyph;
  Vec2 offset{0}, advance{0};
};

bool is_symbol_font(FT_Face face) {
  return face->charmap && face->charmap->platform_id == TT_PLATFORM_MICROSOFT &&
         face->charmap->encoding_id == TT_MS_ID_SYMBOL_CS;
}

/// The bytes as HarfBuzz is to read them: symbol fonts keep theirs in the private page 0xf000.
void add_text(hb_buffer_t* buffer, const std::string& text, bool symbols) {
  hb_buffer_add_utf8(buffer, text.data(), static_cast<int>(text.size()), 0,
                     static_cast<int>(text.size()));
  if (!symbols) return;
  unsigned count = 0;
  hb_glyph_info_t* info = hb_buffer_get_glyph_infos(buffer, &count);
  for (unsigned i = 0; i < count; ++i) {
    if (info[i].codepoint < 0x100) info[i].codepoint += 0xf000;
  }
}

/// What OpenSCAD finds out of a text whose tree does not say it: script, then its direction.
void complete(hb_buffer_t* buffer, const Style& style) {
  hb_buffer_set_direction(buffer, hb_direction_from_string(style.direction.c_str(), -1));
  hb_buffer_set_script(buffer, hb_script_from_string(style.script.c_str(), -1));
  hb_buffer_set_language(buffer, hb_language_from_string(style.language.c_str(), -1));
  hb_buffer_guess_segment_properties(buffer);
}

class Layout {
 public:
  Layout(FT_Face face, const Style& style) : style_(style) {
    if (FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(kScale), kDots, kDots) != 0) return;
    const std::unique_ptr<hb_font_t, DestroyFont> font(hb_ft_font_create(face, nullptr));
    const std::unique_ptr<hb_buffer_t, DestroyBuffer> buffer(hb_buffer_create());
    add_text(buffer.get(), style.text, is_symbol_font(face));
    complete(buffer.get(), style);
    hb_shape(font.get(), buffer.get(), nullptr, 0);
    horizontal_ = HB_DIRECTION_IS_HORIZONTAL(hb_buffer_get_direction(buffer.get()));
    unsigned count = 0;
    const hb_glyph_info_t* info = hb_buffer_get_glyph_infos(buffer.get(), &count);
    const hb_glyph_position_t* place = hb_buffer_get_glyph_positions(buffer.get(), &count);
    for (unsigned i = 0; i < count; ++i) {
      missing = missing || info[i].codepoint == 0;
      FT_Glyph glyph = nullptr;
      if (FT_Load_Glyph(face, info[i].codepoint, FT_LOAD_DEFAULT) != 0) continue;
      if (FT_Get_Glyph(face->glyph, &glyph) != 0) continue;
      glyphs_.push_back({std::unique_ptr<FT_GlyphRec, DoneGlyph>(glyph),
                         kUnscale * Vec2(place[i].x_offset, place[i].y_offset),
                         kUnscale * style.spacing * Vec2(place[i].x_advance, place[i].y_advance)});
    }
  }

  /// Some letter has no glyph in the font.
  bool missing = false;

  std::vector<Region> outlines(RunContext& run) {
    const Vec2 start = aligned();
    Vec2 at(0);
    std::vector<Region> out;
    for (Placed& g : glyphs_) {
      run.check();
      Pen pen(style_.size, style_.pieces);
      pen.offset = start + at + g.offset;
      if (g.glyph->format == FT_GLYPH_FORMAT_OUTLINE) {
        decompose(reinterpret_cast<FT_OutlineGlyph>(g.glyph.get())->outline, pen);
      }
      at += g.advance;
      if (!pen.glyph.empty()) out.push_back(std::move(pen.glyph));
    }
    return out;
  }

 private:
  Vec2 aligned() const {
    double width = 0, ascent = 0, descent = 0;
    for (const Placed& g : glyphs_) {
      FT_BBox box;
      FT_Glyph_Get_CBox(g.glyph.get(), FT_GLYPH_BBOX_GRIDFIT, &box);
      if (horizontal_) {
        width += g.advance.x;
        ascent = std::max(ascent, static_cast<double>(box.yMax) * kUnscale);
        descent = std::max(descent, static_cast<double>(-box.yMin) * kUnscale);
      } else {
        width = std::max(width, static_cast<double>(box.xMax - box.xMin) * kUnscale);
        ascent += g.advance.y;
      }
    }
    const double x = style_.halign == "right" ? -width : style_.halign == "center" ? -width / 2 : 0;
    const double y = style_.valign == "top"      ? -ascent
                     : style_.valign == "center" ? descent / 2 - ascent / 2
                     : style_.valign == "bottom" ? descent
                                                 : 0;
    return {x, y};
  }

  const Style& style_;
  bool horizontal_ = true;
  std::vector<Placed> glyphs_;
};

/// Once, whatever texts there are: it is about the machine.
void report_no_font(Diagnostics& diagnostics) {
  constexpr const char* kCode = "openscad.no_font";
  if (std::ranges::find(diagnostics.entries(), kCode, &Diagnostic::code) !=
      diagnostics.entries().end()) {
    return;
  }
  diagnostics.add(Severity::Warning, kCode, 1,
                  "this machine has no fonts: text() is left out; install some, e.g. the package "
                  "fonts-liberation");
}

}  // namespace

Region lettering(Evaluation& e, std::uint32_t node) {
  const Style style = style_of(e.tree.nodes[node]);
  if (style.text.empty()) return {};
  if (!e.fonts) e.fonts = std::make_shared<Fonts>();
  const Fonts::Found font = e.fonts->find(style.font);
  if (!font.face) {
    report_no_font(e.diagnostics);
    return {};
  }
  if (font.replaced) {
    // OpenSCAD's own choice, where a text names none.
    const std::string name = style.font.empty() ? "Liberation Sans" : style.font;
    report(e, node, "openscad.font_replaced",
           fmt::format("the font {} is missing; {} is used instead", in_quotes(name),
                       font.face->family_name ? font.face->family_name : "another"));
  }
  Layout layout(font.face, style);
  const std::vector<Region> glyphs = layout.outlines(e.run);
  if (layout.missing) {
    report(e, node, "openscad.no_glyph",
           fmt::format("{} has letters that the font lacks", in_quotes(style.text)));
  }
  return clip(ClipOp::Union, glyphs);
}

}  // namespace burin::csg
