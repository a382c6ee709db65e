#pragma once
/// Which colours stand for which items.

#include <burin/annotate/annotate.h>
#include <burin/illustrate/illustrate.h>
#include <burin/surface/scene.h>

#include <span>
#include <vector>

namespace burin {

/// A row for each colour that an item may show: those of parts that are drawn with a flat colour
/// and whose style has `fill.legend`, and of their faces; items of one name and colour once.
/// `options`: its `part_styles` count.
std::vector<LegendRow> legend_rows(const Scene& scene, const Style& style,
                                   const IllustrateOptions& options,
                                   std::span<const DrawingItem> items);

/// What `options` lays over a drawing, with the rows of the legend whose colour any of the areas
/// has, in any tone, told as seen and the others as not. Where there are no annotations, none.
Annotations with_seen_rows(const Scene& scene, const Style& style, const IllustrateOptions& options,
                           std::span<const Area> areas);

}  // namespace burin
