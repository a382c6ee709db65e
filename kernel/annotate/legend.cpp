#include "legend.h"

#include <burin/drawing/font.h>

#include "blocks.h"
#include "fitted_names.h"
#include "frame_path.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

/// Of a square with a name beside it, paper mm; `seen`: of rows that are seen alone.
double width_of(const std::vector<LegendRow>& rows, bool seen, double square, double h) {
  double name = 0;
  for (const LegendRow& row : rows) {
    if (seen && !row.seen) continue;
    name = std::max(name, std::min(text_width(row.name, h), kWidestName * h));
  }
  return square + 0.8 * h + name + 1.2 * h;
}

}  // namespace

std::optional<LegendPlan> plan_legend(const Annotations& annotations, const CalloutOptions& style,
                                      const Box2& frame) {
  const std::vector<LegendRow>& rows = annotations.legend;
  const auto seen = static_cast<std::size_t>(std::ranges::count(rows, true, &LegendRow::seen));
  if (seen == 0) return std::nullopt;
  const double h = style.list_height;
  LegendPlan plan;
  plan.row = 2 * h;
  plan.square = 1.4 * h;
  const auto room = place_blocks({plan.row, width_of(rows, false, plan.square, h), rows.size()},
                                 style.legend, frame, annotations.shape);
  if (!room) return std::nullopt;
  plan.block = width_of(rows, true, plan.square, h);
  static_cast<BlockPlan&>(plan) = seen == rows.size()
                                      ? *room
                                      : place_within(*room, {plan.row, plan.block, seen},
                                                     style.legend, frame, annotations.shape);
  return plan;
}

void lay_legend(const LegendPlan& plan, const Annotations& annotations, const CalloutOptions& style,
                Drawing& drawing) {
  const double h = style.list_height;
  Layer layer{"legend", {}};
  std::vector<std::string> names;
  for (const LegendRow& row : annotations.legend) {
    if (row.seen) names.push_back(row.name);
  }
  names = fitted_names(names, h, plan.block - plan.square - 2 * h + kRounding);
  std::size_t i = 0;
  for (const LegendRow& row : annotations.legend) {
    if (!row.seen) continue;
    const std::size_t column = i / plan.rows;
    const double left = plan.box.min.x + static_cast<double>(column) * plan.block;
    const double middle = plan.box.max.y - (static_cast<double>(i % plan.rows) + 0.5) * plan.row;
    const Vec2 low(left, middle - 0.5 * plan.square), high = low + plan.square;
    Path border = line(low, {high.x, low.y}, style.line);
    border.points.insert(border.points.end(), {high, {low.x, high.y}});
    border.closed = true;
    border.item = row.item;
    Area square = row.square;
    square.role = "legend";
    square.rings = {border.points};
    drawing.areas.push_back(std::move(square));
    layer.paths.push_back(std::move(border));
    layer.texts.push_back(
        {{high.x + 0.8 * h, middle - 0.5 * h}, h, TextAnchor::Start, names[i], "legend", row.item});
    ++i;
  }
  drawing.layers.push_back(std::move(layer));
}

}  // namespace burin::detail
