#pragma once
// Parallel lines over regions of flat colour; internal to the module.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/surface/scene.h>

#include "../part_styles.h"
#include "fills.h"

#include <string>
#include <string_view>

namespace burin::detail {

/// Whether any part that is drawn has such lines.
bool hatches(const PartStyles& part_styles);

/// The colour of such lines over areas of a part that are `color` in full light before they are
/// painted; empty: it has none, or they are in the ink of the sheet.
std::string hatch_color(const Fills& fills, const PartStyles& part_styles, std::size_t part,
                        const std::string& color);

/// Adds the layer "fill-hatch", below all others, with lines over the areas of a drawing but those
/// that are looked through; they have no points in the model. Lines in the colour of a part with a
/// spot ink are in that ink (`Drawing::inks`). Darker areas lie in lighter ones of their part
/// (`areas_of`), so that the lightest one with lines is hatched in one go, and darker ones beside
/// that where lines cross; what lies over the colour of a part has lines of its own. `role`: that
/// of the areas; those of "" have their base colours, which painting changes; those of "legend"
/// with an opacity of 0 lose their colour, which is that of their lines. Throws Cancelled.
void hatch_areas(const Scene& scene, const PartStyles& part_styles, std::string_view role,
                 Drawing& drawing, const RunContext& context);

}  // namespace burin::detail
