#pragma once
// The flat colours of areas; internal to the module.

#include <burin/drawing/drawing.h>
#include <burin/surface/scene.h>

#include "part_styles.h"

#include <vector>

namespace burin::detail {

/// Whether any part that is drawn has a flat colour.
bool paints(const PartStyles& part_styles);

/// Gives areas their colours and brings them into the order of painting: what can be looked through
/// over what is behind it. Parts without a colour of their own have one of a palette that people
/// who see fewer colours can tell apart, by what they are instances of: it stays in all views of a
/// scene. @cite Tol2021
void paint_areas(const Scene& scene, const PartStyles& part_styles, std::vector<Area>& areas);

/// Gives the shade of parts without a colour the colour of shadows.
void shade_areas(const Style& style, std::vector<Area>& areas);

/// Lays a shadow below all areas, in its colour. It is not seen through parts that are opaque, even
/// if their colour is not, or they have none: that is mixed with the paper.
void lay_shadow(Area shadow, const Style& style, const PartStyles& part_styles,
                std::vector<Area>& areas);

}  // namespace burin::detail
