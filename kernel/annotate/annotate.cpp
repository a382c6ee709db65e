#include <burin/annotate/annotate.h>
#include <burin/annotate/place.h>
#include <burin/base/short_list.h>
#include <burin/drawing/font.h>

#include "anchors.h"
#include "frame_path.h"
#include "kept_clear.h"
#include "stroke_directions.h"
#include "tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace burin {
namespace {

constexpr std::size_t kMostNamed = 5;

using detail::Anchor;

Path leader(Vec2 from, Vec2 to, double width, const Anchor& anchor) {
  Path path;
  path.kind = LineClass::Leader;
  path.source.part = anchor.part;
  path.points = {from, to};
  path.width = {width};
  path.item = anchor.item->number;
  return path;
}

/// Leader, its dot or arrow, the circle and the number.
void draw_callout(const Anchor& anchor, Vec2 place, const CalloutSizes& sizes,
                  const CalloutOptions& style, Layer& layer) {
  const double radius = 0.5 * sizes.diameter, distance = glm::distance(anchor.at, place);
  if (distance > radius) {
    const Vec2 way = (place - anchor.at) / distance;
    layer.paths.push_back(leader(anchor.at, place - radius * way, style.line, anchor));
    if (anchor.dot) {
      layer.paths.push_back(leader(anchor.at, anchor.at, std::max(1.1, 6 * style.line), anchor));
    } else {
      const double width = std::max(0.8, 4 * style.line);
      const double head = std::min(3 * width, distance - radius);
      Path arrow = leader(anchor.at + head * way, anchor.at, width, anchor);
      arrow.width = {width, 0};
      layer.paths.push_back(std::move(arrow));
    }
  }
  if (style.circle) {
    Path circle = detail::circle(place, radius, style.line);
    circle.source.part = anchor.part;
    circle.item = anchor.item->number;
    layer.paths.push_back(std::move(circle));
  }
  layer.texts.push_back({place - Vec2(0, 0.5 * style.height), style.height, TextAnchor::Middle,
                         std::to_string(anchor.item->number), "callout", anchor.item->number});
}

Box2 ink_box(const Drawing& drawing) {
  Box2 box;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      for (const Vec2& p : path.points) box.add(p);
    }
    for (const Text& text : layer.texts) box.add(text_box(text));
  }
  return box;
}

int largest_number(const std::vector<DrawingItem>& items) {
  int largest = 1;
  for (const DrawingItem& item : items) largest = std::max(largest, item.number);
  return largest;
}

std::string names_of(const std::vector<const DrawingItem*>& items) {
  return short_list(items, kMostNamed, [](const DrawingItem* item) {
    return fmt::format("{} '{}'", item->number, item->name);
  });
}

void add_callouts(Drawing& drawing, std::span<const Area> seen, const Box2& frame,
                  const Annotations& annotations, const CalloutOptions& style,
                  const RunContext& context) {
  Box2 ink = ink_box(drawing);
  for (const std::vector<Vec2>& line : annotations.over_it) {
    for (const Vec2& p : line) ink.add(p);
  }
  std::vector<const DrawingItem*> not_shown;
  const std::vector<Anchor> anchors =
      detail::find_anchors(drawing, seen, annotations.items, ink.center(), style.layout, not_shown);
  if (!not_shown.empty()) {
    drawing.diagnostics.add(
        Severity::Warning, "callouts.not_shown", std::ssize(not_shown),
        "items that are not seen in this view have no callout: " + names_of(not_shown));
  }
  if (anchors.empty()) return;
  const CalloutSizes sizes(style, largest_number(annotations.items));
  std::vector<Vec2> points;
  for (const Anchor& anchor : anchors) points.push_back(anchor.at);
  const detail::StrokeDirections directions(drawing);
  const detail::KeptClear others(drawing, annotations.over_it);
  const LeaderCosts costs{.along = [&](Vec2 from, Vec2 to) { return directions.along(from, to); },
                          .over = [&](Vec2 from, Vec2 to) { return others.passed_over(from, to); }};
  const CalloutPlaces places =
      place_callouts(points, ink, frame, sizes, style.layout, context, costs);
  if (places.unfinished) {
    drawing.diagnostics.add(Severity::Warning, "callouts.many", std::ssize(anchors),
                            fmt::format("{} callouts are too many to keep all leaders from "
                                        "crossing: number fewer parts",
                                        anchors.size()));
  }
  CalloutSizes drawn = sizes;
  CalloutOptions how = style;
  // Where neighbours would touch, numbers become smaller: all are there and can be read.
  constexpr double kBetween = 1.08;
  if (const double most = places.pitch / kBetween; most < sizes.diameter) {
    how.height *= most / sizes.diameter;
    drawn.diameter = most;
  }
  if (places.lacking > 1) {
    drawing.diagnostics.add(
        Severity::Warning, "callouts.crowded", std::ssize(anchors),
        fmt::format("{} callouts do not fit on a sheet of {:g} x {:g} mm: their numbers, {:.2g} "
                    "mm high, are too close together or over the drawing; they need a sheet of "
                    "{:.0f} x {:.0f} mm, or a smaller callout.height",
                    anchors.size(), drawing.paper_width, drawing.paper_height, how.height,
                    std::ceil(drawing.paper_width * places.lacking),
                    std::ceil(drawing.paper_height * places.lacking)));
  }
  Layer layer{"callouts", {}};
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    draw_callout(anchors[i], places.at[i], drawn, how, layer);
  }
  drawing.layers.push_back(std::move(layer));
}

}  // namespace

Margin annotation_margin(const Annotations& annotations, const CalloutOptions& style,
                         const Paper& paper) {
  const Box2 rest = detail::plan_tables(annotations, style, paper).rest;
  Margin m(paper.height - rest.max.y, paper.width - rest.max.x, rest.min.y, rest.min.x);
  if (!annotations.callouts || annotations.items.empty()) return m;
  const CalloutSizes sizes(style, largest_number(annotations.items));
  const double border = sizes.diameter + sizes.gap;
  const CalloutCapacity room = callout_capacity(rest, rest, sizes);
  const std::size_t n = annotations.items.size();
  using Layout = CalloutOptions::Layout;
  const bool rows = style.layout != Layout::Columns || n > 2 * room.column;
  const bool columns = style.layout != Layout::Rows || n > 2 * room.row;
  if (columns) m.left += border, m.right += border;
  if (rows) m.top += border, m.bottom += border;
  // Whatever is left for the drawing, something is: that it does not fit is told later.
  const double least = 0.1 * std::min(paper.width, paper.height);
  const auto shrink = [&](double& a, double& b, double side) {
    const double most = side - least;
    if (a + b <= most) return;
    const double f = std::max(most, 0.0) / (a + b);
    a *= f, b *= f;
  };
  shrink(m.left, m.right, paper.width);
  shrink(m.top, m.bottom, paper.height);
  return m;
}

bool annotations_fit(const Annotations& annotations, const CalloutOptions& style,
                     const Paper& paper, const Margin& border) {
  const detail::Tables tables = detail::plan_tables(annotations, style, paper);
  if (!tables.fit(annotations)) return false;
  const Margin needed = annotation_margin(annotations, style, paper);
  constexpr double kRounding = 1e-9;
  if (needed.left > border.left + kRounding || needed.right > border.right + kRounding ||
      needed.top > border.top + kRounding || needed.bottom > border.bottom + kRounding) {
    return false;
  }
  if (!annotations.callouts || annotations.items.empty()) return true;
  return callouts_fit(annotations.items.size(), inside(paper, border), tables.rest,
                      CalloutSizes(style, largest_number(annotations.items)), style.layout);
}

void annotate(Drawing& drawing, std::span<const Area> seen, const Annotations& annotations,
              const CalloutOptions& style, const RunContext& context) {
  drawing.items = annotations.items;
  const Paper paper{drawing.paper_width, drawing.paper_height};
  const detail::Tables tables = detail::plan_tables(annotations, style, paper);
  if (annotations.callouts) {
    add_callouts(drawing, seen, tables.rest, annotations, style, context);
  }
  detail::lay_tables(tables, annotations, style, drawing);
}

}  // namespace burin
