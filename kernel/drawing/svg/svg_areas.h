#pragma once
// Areas of flat colour in SVG; internal to the module.

#include <burin/drawing/drawing.h>
#include <burin/drawing/text.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

/// The classes of the painted areas of a drawing: "part_0 tone_1". Where a part has several colours
/// in a tone, since its faces have their own, all but the first have one more: "color_2".
class SvgAreaClasses {
 public:
  explicit SvgAreaClasses(const Drawing& drawing);
  std::string of(const Area& area) const;
  /// From 0, which is the only one of most parts.
  std::size_t color(const Area& area) const;

 private:
  std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::string>> colors_;
};

/// The colour of an area, as attributes that programs without style sheets know.
void append_area_fill(Buffer& out, const Area& area);

/// The rings as data of a path.
void append_area_rings(Buffer& out, const Area& area, double paper_height);

/// A style sheet by which a page gives areas other colours through custom properties: "--part-0",
/// "--part-0-tone-1" (the lightest tone of a part has "--part-0" without its own), with "-color-2"
/// for another colour of its faces, "--shadow", and
/// "--ink" for lines and letters in the ink of the drawing, which is `ink`. Rules have no
/// specificity: any rule of the page comes before them. Programs that do not know custom properties
/// pass over all of it. `id`: of the group of areas. Empty where nothing is painted.
std::string svg_area_rules(const Drawing& drawing, const SvgAreaClasses& classes,
                           std::string_view id, std::string_view ink);

}  // namespace burin
