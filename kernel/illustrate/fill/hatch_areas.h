#pragma once
// Parallel lines over regions of flat colour; internal to the module.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/surface/scene.h>

#include "../part_styles.h"

#include <string_view>

namespace burin::detail {

/// Whether any part that is drawn has such lines.
bool hatches(const PartStyles& part_styles);

/// Adds the layer "fill-hatch", below all others, with lines over the areas of a drawing but those
/// that are looked through; they have no points in the model. Lines in the colour of a part with a
/// spot ink are in that ink (`Drawing::inks`). Darker areas lie in lighter ones of their part
/// (`areas_of`), so that the lightest one with lines is hatched in one go, and darker ones beside
/// that where lines cross; what lies over the colour of a part has lines of its own. `role`: that
/// of the areas; those of "" have their base colours, which painting changes. Throws Cancelled.
void hatch_areas(const Scene& scene, const PartStyles& part_styles, std::string_view role,
                 Drawing& drawing, const RunContext& context);

}  // namespace burin::detail
