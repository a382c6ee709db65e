#include "tables.h"

#include <burin/annotate/legend_box.h>
#include <burin/drawing/font.h>

#include "missing_letters.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace detail {

void report_missing_letters(const std::vector<std::string>& texts, Diagnostics& diagnostics) {
  std::size_t missing = 0;
  const std::string* first = nullptr;
  for (const std::string& text : texts) {
    const std::size_t of_text = missing_glyphs(text);
    if (of_text > 0 && !first) first = &text;
    missing += of_text;
  }
  if (missing == 0) return;
  diagnostics.add(Severity::Warning, "text.no_glyph", static_cast<std::int64_t>(missing),
                  fmt::format("characters that the drawing font lacks are boxes, except in SVG, "
                              "HTML and DXF; the first in '{}'",
                              *first));
}

namespace {

void add_list(const std::optional<ListPlan>& plan, const Annotations& annotations,
              const CalloutOptions& style, Drawing& drawing) {
  if (!plan) {
    drawing.diagnostics.add(
        Severity::Warning, "parts_list.no_room", 1,
        fmt::format("a parts list of {} rows does not fit beside the drawing on a sheet of {:g} x "
                    "{:g} mm: give a larger `paper`, a smaller callout.list_height, or write it as "
                    "a file",
                    annotations.items.size(), drawing.paper_width, drawing.paper_height));
    return;
  }
  std::vector<std::string> names;
  for (const DrawingItem& item : annotations.items) names.push_back(item.name);
  report_missing_letters(names, drawing.diagnostics);
  drawing.layers.push_back(list_layer(annotations.items, style, *plan));
}

void add_legend(const std::optional<LegendPlan>& plan, const Annotations& annotations,
                const CalloutOptions& style, Drawing& drawing) {
  if (!plan) {
    drawing.diagnostics.add(
        Severity::Warning, "legend.no_room", 1,
        fmt::format("a legend of {} rows does not fit beside the drawing on a sheet of {:g} x {:g} "
                    "mm: give a larger `paper` or a smaller callout.list_height",
                    annotations.legend.size(), drawing.paper_width, drawing.paper_height));
    return;
  }
  std::vector<std::string> names;
  for (const LegendRow& row : annotations.legend) {
    if (row.seen) names.push_back(row.name);
  }
  if (!annotations.parts_list) report_missing_letters(names, drawing.diagnostics);
  lay_legend(*plan, annotations, style, drawing);
}

void add_title_block(const std::optional<TitleBlockPlan>& plan, const Annotations& annotations,
                     const CalloutOptions& style, Drawing& drawing) {
  const TitleBlock& block = *annotations.title_block;
  if (!plan) {
    const std::string size =
        block.layout ? fmt::format("of {:g} x {:g} mm", block.layout->size.x, block.layout->size.y)
                     : fmt::format("at least {:g} mm wide", kLeastTitleBlock);
    drawing.diagnostics.add(
        Severity::Warning, "title_block.no_room", 1,
        fmt::format("a title block {} does not fit beside the drawing on a sheet of {:g} x {:g} "
                    "mm: give a larger `paper` or a smaller `margin`",
                    size, drawing.paper_width, drawing.paper_height));
    return;
  }
  std::vector<std::string> values;
  for (const auto& [name, value] : block.fields) values.push_back(value);
  report_missing_letters(values, drawing.diagnostics);
  lay_title_block(*plan, block, style, drawing);
}

/// What a block in the lower right corner leaves of the sheet: what is above it and the list, or
/// beside it where there is no list on it.
void keep_clear(const Box2& block, const Annotations& annotations, const Box2& frame,
                Tables& tables) {
  constexpr double kLeast = 0.3;  // share of the frame that a drawing keeps
  tables.rest.min.y = std::max(tables.rest.min.y, block.max.y + kApart);
  if (tables.list) return;
  Box2 beside = frame;
  beside.max.x = block.min.x - kApart;
  if (beside.size().x < kLeast * frame.size().x) return;
  const auto scale = [&](const Box2& box) { return scale_in(box.size(), annotations.shape); };
  if (scale(beside) > scale(tables.rest)) tables.rest = beside;
}

bool has_legend(const Annotations& annotations) {
  return std::ranges::any_of(annotations.legend, &LegendRow::seen);
}

}  // namespace

bool Tables::fit(const Annotations& annotations) const {
  const bool block_fits = block ? !block->narrow : !annotations.title_block.has_value();
  return block_fits && (list || !annotations.parts_list) && (legend || !has_legend(annotations));
}

Tables plan_tables(const Annotations& annotations, const CalloutOptions& style,
                   const Paper& paper) {
  const Box2 frame = inside(paper, annotations.margin);
  Tables tables{.rest = frame};
  tables.block = plan_title_block(annotations, style, paper);
  const Box2 taken = tables.block ? tables.block->box : Box2();
  if (!taken.empty()) tables.rest.min.y = taken.max.y;
  if (annotations.parts_list) tables.list = plan_list(annotations, style, tables.rest);
  if (tables.list) tables.rest = tables.list->rest;
  if (!taken.empty()) keep_clear(taken, annotations, frame, tables);
  tables.legend = plan_legend(annotations, style, tables.rest);
  if (tables.legend) tables.rest = tables.legend->rest;
  return tables;
}

void lay_tables(const Tables& tables, const Annotations& annotations, const CalloutOptions& style,
                Drawing& drawing) {
  if (annotations.title_block) add_title_block(tables.block, annotations, style, drawing);
  if (annotations.parts_list) add_list(tables.list, annotations, style, drawing);
  if (has_legend(annotations)) add_legend(tables.legend, annotations, style, drawing);
}

}  // namespace detail

Box2 beside_tables(const Annotations& annotations, const CalloutOptions& style,
                   const Paper& paper) {
  return detail::plan_tables(annotations, style, paper).rest;
}

std::optional<Box2> parts_list_box(const Annotations& annotations, const CalloutOptions& style,
                                   const Paper& paper) {
  const auto plan = detail::plan_tables(annotations, style, paper).list;
  return plan ? std::optional(plan->box) : std::nullopt;
}

std::optional<Box2> legend_box(const Annotations& annotations, const CalloutOptions& style,
                               const Paper& paper) {
  const auto plan = detail::plan_tables(annotations, style, paper).legend;
  return plan ? std::optional(plan->box) : std::nullopt;
}

double scale_beside_tables(const Annotations& annotations, const CalloutOptions& style,
                           const Paper& paper) {
  return detail::scale_in(detail::plan_tables(annotations, style, paper).rest.size(),
                          annotations.shape);
}

void lay_tables(Drawing& drawing, const Annotations& annotations, const CalloutOptions& style) {
  const Paper paper{drawing.paper_width, drawing.paper_height};
  detail::lay_tables(detail::plan_tables(annotations, style, paper), annotations, style, drawing);
}

}  // namespace burin
