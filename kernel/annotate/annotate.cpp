#include <burin/annotate/annotate.h>
#include <burin/annotate/place.h>
#include <burin/base/short_list.h>
#include <burin/drawing/font.h>
#include <burin/drawing/length.h>

#include "frame_path.h"
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

constexpr double kLeastDisc = 0.8;  // paper mm of radius for a dot
constexpr double kAsWell = 0.75;    // of the radius of the largest disc
constexpr std::size_t kMostNamed = 5;

struct Anchor {
  const DrawingItem* item = nullptr;
  std::int32_t part = -1;
  Vec2 at{0};
  bool dot = true;
};

using Lines = std::map<std::int32_t, std::vector<const Path*>>;

/// The visible lines of each part, without strokes.
Lines lines_by_part(const Drawing& drawing) {
  Lines lines;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      const bool line = path.visible && path.kind != LineClass::Stroke && path.points.size() > 1;
      if (line) lines[path.source.part].push_back(&path);
    }
  }
  return lines;
}

/// The point half-way along a path.
Vec2 middle_of(const Path& path) {
  double left = 0.5 * length_of(path);
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const double step = glm::distance(path.points[i - 1], path.points[i]);
    if (step >= left && step > 0) return glm::mix(path.points[i - 1], path.points[i], left / step);
    left -= step;
  }
  return path.points.back();
}

/// The middle of the longest visible line of a part that lies on what is seen of it.
std::optional<Vec2> longest_line(const Lines& lines, std::int32_t part, const LabelMap& map) {
  const auto of_part = lines.find(part);
  if (of_part == lines.end()) return std::nullopt;
  std::optional<Vec2> best;
  double longest = -1;
  for (const Path* path : of_part->second) {
    const double length = length_of(*path);
    if (length <= longest) continue;
    const Vec2 at = middle_of(*path);
    if (!map.shows(part, at)) continue;
    longest = length;
    best = at;
  }
  return best;
}

/// Lines that a dot should not lie on.
std::vector<std::vector<Vec2>> lines_of(const Drawing& drawing) {
  std::vector<std::vector<Vec2>> lines;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!path.visible || path.kind == LineClass::Stroke || path.kind == LineClass::Pattern) {
        continue;
      }
      lines.push_back(path.points);
      if (path.closed && !path.points.empty()) lines.back().push_back(path.points.front());
    }
  }
  return lines;
}

/// Clear of lines where there is room for a dot, else as far from other parts as can be.
std::vector<Pole> poles_of(const LabelMap& map, std::size_t count,
                           std::span<const std::vector<Vec2>> lines) {
  std::vector<Pole> poles = find_poles(map, count, lines);
  const std::vector<Pole> plain = find_poles(map, count);
  for (std::size_t i = 0; i < poles.size(); ++i) {
    if (poles[i].radius <= kLeastDisc) poles[i] = plain[i];
  }
  return poles;
}

std::vector<Anchor> find_anchors(const Drawing& drawing, const std::vector<const LabelMap*>& maps,
                                 const std::vector<DrawingItem>& items, Vec2 middle,
                                 CalloutOptions::Layout layout,
                                 std::vector<const DrawingItem*>& not_shown) {
  std::int32_t last = -1;
  for (const DrawingItem& item : items) {
    for (const std::int32_t part : item.parts) last = std::max(last, part);
  }
  const auto count = static_cast<std::size_t>(last + 1);
  const std::vector<std::vector<Vec2>> lines = lines_of(drawing);
  std::vector<std::vector<Pole>> poles;
  for (const LabelMap* map : maps) poles.push_back(poles_of(*map, count, lines));
  const Lines by_part = lines_by_part(drawing);
  std::vector<Anchor> anchors;
  for (const DrawingItem& item : items) {
    double largest = 0;
    for (const std::int32_t part : item.parts) {
      const auto i = static_cast<std::size_t>(part);
      for (const std::vector<Pole>& in_map : poles) largest = std::max(largest, in_map[i].radius);
    }
    if (largest <= 0) {
      not_shown.push_back(&item);
      continue;
    }
    // Of those that are seen about as well, the outermost: its leader passes over the fewest.
    Pole pole;
    const LabelMap* map = maps.front();
    double farthest = -1;
    const auto look = [&](const Pole& one, const LabelMap* in) {
      if (one.radius < kAsWell * largest) return;
      const Vec2 off = glm::abs(one.at - middle);
      const double out = layout == CalloutOptions::Layout::Columns ? off.x
                         : layout == CalloutOptions::Layout::Rows  ? off.y
                                                                   : std::max(off.x, off.y);
      if (out > farthest) farthest = out, pole = one, map = in;
    };
    for (const std::int32_t part : item.parts) {
      for (std::size_t m = 0; m < maps.size(); ++m) {
        look(poles[m][static_cast<std::size_t>(part)], maps[m]);
      }
    }
    Anchor anchor{&item, pole.part, pole.at, pole.radius > kLeastDisc};
    if (!anchor.dot) {
      const auto line = longest_line(by_part, pole.part, *map);
      if (line) anchor.at = *line;
    }
    anchors.push_back(anchor);
  }
  return anchors;
}

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

void add_callouts(Drawing& drawing, const std::vector<const LabelMap*>& maps, const Box2& frame,
                  const Annotations& annotations, const CalloutOptions& style,
                  const RunContext& context) {
  const Box2 ink = ink_box(drawing);
  std::vector<const DrawingItem*> not_shown;
  const std::vector<Anchor> anchors =
      find_anchors(drawing, maps, annotations.items, ink.center(), style.layout, not_shown);
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
  const CalloutPlaces places =
      place_callouts(points, ink, frame, sizes, style.layout, context,
                     [&](Vec2 from, Vec2 to) { return directions.along(from, to); });
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
  const Box2 frame = inside(paper, annotations.margin);
  const Box2 rest = detail::plan_tables(annotations, style, frame).rest;
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
  const Box2 frame = inside(paper, annotations.margin);
  const detail::Tables tables = detail::plan_tables(annotations, style, frame);
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

void annotate(Drawing& drawing, const LabelMap& seen, std::span<const LabelMap> glass,
              const Annotations& annotations, const CalloutOptions& style,
              const RunContext& context) {
  drawing.items = annotations.items;
  const Paper paper{drawing.paper_width, drawing.paper_height};
  const Box2 frame = inside(paper, annotations.margin);
  const detail::Tables tables = detail::plan_tables(annotations, style, frame);
  if (annotations.callouts) {
    std::vector<const LabelMap*> maps{&seen};
    for (const LabelMap& map : glass) maps.push_back(&map);
    add_callouts(drawing, maps, tables.rest, annotations, style, context);
  }
  detail::lay_tables(tables, annotations, style, drawing);
}

}  // namespace burin
