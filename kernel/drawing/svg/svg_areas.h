#pragma once
// Areas of flat colour in SVG; internal to the module.

#include <burin/drawing/drawing.h>
#include <burin/drawing/text.h>

#include <string>
#include <string_view>

namespace burin {

/// The classes of a painted area: "part_0 tone_1".
std::string svg_area_classes(const Area& area);

/// The colour of an area, as attributes that programs without style sheets know.
void append_area_fill(Buffer& out, const Area& area);

/// The rings as data of a path.
void append_area_rings(Buffer& out, const Area& area, double paper_height);

/// A style sheet by which a page gives areas other colours through custom properties: "--part-0",
/// "--part-0-tone-1" (the lightest tone of a part has "--part-0" without its own), "--shadow", and
/// "--ink" for lines and letters in the ink of the drawing, which is `ink`. Rules have no
/// specificity: any rule of the page comes before them. Programs that do not know custom properties
/// pass over all of it. `id`: of the group of areas. Empty where nothing is painted.
std::string svg_area_rules(const Drawing& drawing, std::string_view id, std::string_view ink);

}  // namespace burin
