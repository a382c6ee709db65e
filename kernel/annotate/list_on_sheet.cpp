#include "list_on_sheet.h"

#include <burin/annotate/list_pages.h>
#include <burin/drawing/font.h>

#include "blocks.h"
#include "fitted_names.h"
#include "frame_path.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

constexpr const char* kNumber = "No.";
constexpr const char* kQuantity = "Qty";
constexpr const char* kName = "Name";

}  // namespace

ListPlan columns_of(std::span<const DrawingItem> items, const CalloutOptions& style) {
  const double h = style.list_height;
  const auto width = [&](const std::string& text) { return text_width(text, h) + 1.6 * h; };
  ListPlan plan;
  plan.row = 2 * h;
  plan.number = width(kNumber), plan.quantity = width(kQuantity), plan.name = width(kName);
  for (const DrawingItem& item : items) {
    plan.number = std::max(plan.number, width(std::to_string(item.number)));
    plan.quantity = std::max(plan.quantity, width(std::to_string(item.quantity())));
    plan.name = std::max(plan.name, std::min(width(item.name), kWidestName * h));
  }
  return plan;
}

std::optional<ListPlan> plan_list(const Annotations& annotations, const CalloutOptions& style,
                                  const Box2& frame) {
  ListPlan plan = columns_of(annotations.items, style);
  const auto blocks = place_blocks({plan.row, plan.block(), annotations.items.size(), 1},
                                   Corner::BottomRight, frame, annotations.shape);
  if (!blocks) return std::nullopt;
  static_cast<BlockPlan&>(plan) = *blocks;
  return plan;
}

Layer list_layer(std::span<const DrawingItem> items, const CalloutOptions& style,
                 const ListPlan& plan) {
  Layer layer{"parts_list", {}};
  const double h = style.list_height, inset = 0.8 * h;
  const double thick = 2 * style.line;  // the outer frame and below the heading, after ISO 7573
  const auto write = [&](const std::string& text, double x, double y, TextAnchor anchor, int item) {
    layer.texts.push_back({{x, y + 0.5 * (plan.row - h)}, h, anchor, text, "parts_list", item});
  };
  std::vector<std::string> names;
  for (const DrawingItem& item : items) names.push_back(item.name);
  names = fitted_names(names, h, plan.name - 2 * inset + kRounding);
  for (std::size_t block = 0; block < plan.blocks; ++block) {
    const std::size_t first = block * plan.rows;
    const std::size_t rows = std::min(plan.rows, items.size() - std::min(first, items.size()));
    if (rows == 0 && block > 0) continue;
    const double right = plan.box.max.x - static_cast<double>(block) * plan.block();
    const double left = right - plan.block(), height = static_cast<double>(rows + 1) * plan.row;
    const double bottom = plan.downwards ? plan.box.max.y - height : plan.box.min.y;
    const double top = bottom + height;
    const double x1 = left + plan.number, x2 = x1 + plan.quantity;
    // The heading is row 0.
    const auto bottom_of = [&](std::size_t row) {
      return bottom + static_cast<double>(plan.downwards ? rows - row : row) * plan.row;
    };
    write(kNumber, x1 - inset, bottom_of(0), TextAnchor::End, 0);
    write(kQuantity, x2 - inset, bottom_of(0), TextAnchor::End, 0);
    write(kName, x2 + inset, bottom_of(0), TextAnchor::Start, 0);
    for (std::size_t i = 0; i < rows; ++i) {
      const DrawingItem& item = items[first + i];
      const double y = bottom_of(i + 1);
      write(std::to_string(item.number), x1 - inset, y, TextAnchor::End, item.number);
      write(std::to_string(item.quantity()), x2 - inset, y, TextAnchor::End, item.number);
      write(names[first + i], x2 + inset, y, TextAnchor::Start, item.number);
      const double between = plan.downwards ? y + plan.row : y;
      layer.paths.push_back(line({left, between}, {right, between}, i == 0 ? thick : style.line));
    }
    layer.paths.push_back(line({x1, bottom}, {x1, top}, style.line));
    layer.paths.push_back(line({x2, bottom}, {x2, top}, style.line));
    Path outer = line({left, bottom}, {right, bottom}, thick);
    outer.points.insert(outer.points.end(), {{right, top}, {left, top}});
    outer.closed = true;
    layer.paths.push_back(std::move(outer));
  }
  return layer;
}

}  // namespace burin::detail

namespace burin {

std::vector<Drawing> list_pages(std::span<const DrawingItem> items, const CalloutOptions& style,
                                const Paper& paper, const Margin& margin) {
  const Box2 frame = inside(paper, margin);
  detail::ListPlan plan = detail::columns_of(items, style);
  plan.downwards = true;
  plan.name = std::min(plan.name, frame.size().x - plan.number - plan.quantity);
  const double room = frame.size().y / plan.row - 1;
  const auto most = static_cast<std::size_t>(std::max(1.0, std::floor(room)));
  plan.box = {{frame.min.x, frame.min.y}, {frame.min.x + plan.block(), frame.max.y}};
  std::vector<Drawing> pages;
  for (std::size_t first = 0; first < items.size(); first += most) {
    plan.rows = std::min(most, items.size() - first);
    Drawing page;
    page.paper_width = paper.width;
    page.paper_height = paper.height;
    page.title = "Parts list";
    page.layers.push_back(detail::list_layer(items.subspan(first, plan.rows), style, plan));
    pages.push_back(std::move(page));
  }
  return pages;
}

}  // namespace burin
