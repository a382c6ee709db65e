#pragma once
// text(): outlines of glyphs; for converters/openscad alone.

#include "flat.h"

namespace burin::csg {

/// The outlines of a text by its size, spacing, font, direction, language, script, halign and
/// valign, laid out by HarfBuzz in the font that fontconfig finds, as OpenSCAD has it. Text without
/// glyphs and a font that is another than asked for are told in the diagnostics. Cost: once for an
/// evaluation the configuration of fontconfig, then little more than the union of the glyphs.
Region lettering(Evaluation& e, std::uint32_t node);

}  // namespace burin::csg
