#pragma once
/// Which colours stand for which items.

#include <burin/annotate/annotate.h>
#include <burin/illustrate/illustrate.h>
#include <burin/surface/scene.h>

#include <span>
#include <vector>

namespace burin {

/// A row for each colour that an item may show: those of parts that are drawn with a flat colour,
/// or hatched in one alone, and whose style has `fill.legend`, and of their faces; items of one
/// name and colour once. Squares that are hatched alone have the colour of the lines and an opacity
/// of 0. `options`: its `part_styles` count.
std::vector<LegendRow> legend_rows(const Scene& scene, const Style& style,
                                   const IllustrateOptions& options,
                                   std::span<const DrawingItem> items);

/// What `options` lays over a drawing, with the rows of the legend whose colour any of its areas
/// has, in any tone, or its hatching, marked as seen and the others as not. An area that is nowhere
/// as wide as a pen (`line.crease`) is not seen. Where there are no annotations, none.
Annotations with_seen_rows(const Scene& scene, const Style& style, const IllustrateOptions& options,
                           const Drawing& drawing);

}  // namespace burin
