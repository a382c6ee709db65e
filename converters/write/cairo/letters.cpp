#include "letters.h"

#include <burin/base/error.h>
#include <burin/drawing/font.h>
#include <burin/drawing/text.h>

#include "shapes.h"

#include <cairo-ft.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {
namespace {

/// The font as cairo has it. cairo keeps what it made of it until the program ends, and locks it
/// where several threads write.
class Face {
 public:
  static cairo_font_face_t* get() {
    static const Face face;
    return face.cairo_;
  }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

 private:
  Face() {
    const auto bytes = font_file();
    if (FT_Init_FreeType(&library_) != 0 ||
        FT_New_Memory_Face(library_, bytes.data(), static_cast<FT_Long>(bytes.size()), 0, &face_) !=
            0) {
      throw Error("FreeType cannot read the font of texts");
    }
    cairo_ = cairo_ft_font_face_create_for_ft_face(face_, FT_LOAD_NO_HINTING);
    check(cairo_font_face_status(cairo_));
  }
  ~Face() = default;  // cairo may still have it

  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
  cairo_font_face_t* cairo_ = nullptr;
};

}  // namespace

void show_letters(cairo_t* pen, const Text& text) {
  std::string utf8;
  std::vector<cairo_glyph_t> glyphs;
  std::vector<cairo_text_cluster_t> clusters;
  for (const PlacedLetter& letter : placed_letters(text)) {
    const std::string bytes = utf8_of(letter.character);
    utf8 += bytes;
    glyphs.push_back({letter.glyph, letter.at.x, letter.at.y});
    clusters.push_back({static_cast<int>(bytes.size()), 1});
  }
  const double size = font_size(text.height);
  const Vec2 right = size * way_of(text), up(-right.y, right.x);
  cairo_matrix_t upright;  // the pen's y goes up, that of a font down
  cairo_matrix_init(&upright, right.x, right.y, -up.x, -up.y, 0, 0);
  cairo_set_font_face(pen, Face::get());
  cairo_set_font_matrix(pen, &upright);
  cairo_show_text_glyphs(pen, utf8.data(), static_cast<int>(utf8.size()), glyphs.data(),
                         static_cast<int>(glyphs.size()), clusters.data(),
                         static_cast<int>(clusters.size()), {});
}

}  // namespace burin
