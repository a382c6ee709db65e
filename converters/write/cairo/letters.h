#pragma once
/// Texts as texts: letters of the font that is embedded in a PDF, which programs find and copy.

#include <burin/drawing/drawing.h>

#include <cairo.h>

namespace burin {

/// Shows a text in the pen's colour, each letter where `text_ink` has its outline. A character that
/// the font has not is a box, which is copied as that character.
void show_letters(cairo_t* pen, const Text& text);

}  // namespace burin
