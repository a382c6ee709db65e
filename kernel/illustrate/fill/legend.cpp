#include <burin/illustrate/legend.h>

#include "fills.h"

#include <algorithm>
#include <utility>

namespace burin {

std::vector<LegendRow> legend_rows(const Scene& scene, const Style& style,
                                   const IllustrateOptions& options,
                                   std::span<const DrawingItem> items) {
  const detail::PartStyles part_styles(scene, style, options);
  const detail::Fills fills(scene, part_styles);
  std::vector<LegendRow> rows;
  for (const DrawingItem& item : items) {
    for (const std::int32_t part : item.parts) {
      const auto i = static_cast<std::size_t>(part);
      if (!part_styles.drawn(i) || !part_styles.style(i).fill.legend) continue;
      LegendRow row{item.number, item.name, {.part = part, .rings = {}}};
      fills.paint(row.square);
      if (row.square.fill.empty()) continue;
      const bool known = std::ranges::any_of(rows, [&](const LegendRow& other) {
        return other.name == row.name && other.square.fill == row.square.fill;
      });
      if (!known) rows.push_back(std::move(row));
    }
  }
  return rows;
}

}  // namespace burin
