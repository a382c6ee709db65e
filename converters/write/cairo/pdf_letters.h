#pragma once
/// The font of a PDF that is written without cairo: its letters are outlines that are painted in
/// the ink of the text (Type 3 fonts), so that spot inks reach them. @cite PDF17

#include <burin/drawing/drawing.h>
#include <burin/drawing/text.h>

#include "pdf_objects.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace burin {

/// The characters that texts of a file have, in fonts of 256 each, in the order of their first use.
class PdfLetters {
 public:
  /// The operators that show a text; notes its characters.
  void show(const Text& text, Buffer& out);

  /// Writes the fonts; returns what resources say of them: "<< /F0 7 0 R >>".
  std::string write(PdfObjects& file) const;

 private:
  std::size_t place(char32_t character);
  std::size_t write_font(std::size_t font, PdfObjects& file) const;

  std::map<char32_t, std::size_t> places_;
  std::vector<char32_t> characters_;
};

}  // namespace burin
