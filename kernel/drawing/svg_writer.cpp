#include <burin/drawing/bezier.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/ordered_text.h>
#include <burin/drawing/writers.h>

#include "svg_path.h"
#include "svg_tags.h"

#include <algorithm>
#include <ostream>
#include <set>

namespace burin {
namespace {

/// One path with the tags that come before it.
struct Item {
  std::string before;
  const Path* path = nullptr;
};

std::string part_tag(std::int32_t part, const std::string& id, const Drawing& drawing) {
  Buffer out;
  append(out, fmt::format("<g id=\"{}\" data-part=\"{}\"><title>", id, part));
  const auto it = std::find_if(drawing.parts.begin(), drawing.parts.end(),
                               [&](const DrawingPart& p) { return p.id == part; });
  if (it != drawing.parts.end() && !it->name.empty()) {
    append_xml(out, it->name);
  } else {
    append(out, part < 0 ? std::string("no part") : fmt::format("part {}", part));
  }
  append(out, "</title>\n");
  return fmt::to_string(out);
}

/// All paths in order; the last item has none, only the closing tags.
std::vector<Item> items_of(const Drawing& drawing, const std::vector<InkLayer>& groups,
                           const SvgOptions& options) {
  std::vector<Item> items;
  std::set<std::string> ids;
  std::string before = svg_head(drawing);
  for (const InkLayer& group : groups) {
    const std::string id = svg_id(group.name, ids);
    before += svg_layer_tag(group, id, options);
    for (const auto& [part, paths] : group.parts) {
      const std::string stem = part < 0 ? "none" : fmt::format("{}", part);
      before += part_tag(part, svg_id(id + "-" + stem, ids), drawing);
      for (const Path* path : paths) {
        items.push_back({std::move(before), path});
        before.clear();
      }
      before += "</g>\n";
    }
    before += "</g>\n";
  }
  items.push_back({before + "</svg>\n", nullptr});
  return items;
}

void append_source(Buffer& out, const Path& p) {
  const char* kind = to_string(p.kind);
  fmt::format_to(
      fmt::appender(out),
      " class=\"{}\" data-part=\"{}\" data-face=\"{}\" data-edge=\"{}\" data-kind=\"{}\"", kind,
      p.source.part, p.source.face, p.source.edge, kind);
}

void append_polyline(Buffer& out, SvgPen& pen, const Path& p, double tolerance) {
  std::vector<Vec2> all = p.points;
  if (p.closed) all.push_back(all.front());
  std::vector<Vec2> kept;
  for (const std::size_t i : simplify(all, tolerance)) kept.push_back(all[i]);
  append(out, "<polyline");
  append_source(out, p);
  append_pen(out, mean_width(p));
  append(out, " points=\"");
  pen.points(kept);
  append(out, "\"/>\n");
}

void append_path(Buffer& out, const Path& p, double paper_height, const SvgOptions& options) {
  SvgPen pen(out, paper_height);
  if (options.flatten_polylines) return append_polyline(out, pen, p, options.fit_tolerance);
  const Ink ink = ink_of(p, curve_tolerance(options));
  append(out, "<path");
  append_source(out, p);
  if (ink.filled) {
    append(out, " fill=\"#000\" stroke=\"none\"");
  } else {
    append_pen(out, ink.width);
  }
  append(out, " d=\"");
  for (const auto& chain : ink.chains) pen.chain(chain, ink.filled || p.closed);
  if (ink.chains.front().empty()) pen.dot(p.points.front());
  append(out, "\"/>\n");
}

}  // namespace

void write_svg(const Drawing& drawing, const SvgOptions& options, std::ostream& out,
               const RunContext& context) {
  if (options.merge) return write_merged_svg(drawing, options, out, context);
  const std::vector<Item> items = items_of(drawing, ink_layers(drawing), options);
  write_ordered(
      items.size(), [&](std::size_t i) { return items[i].path ? items[i].path->points.size() : 0; },
      [&](std::size_t i, Buffer& buffer) {
        append(buffer, items[i].before);
        if (items[i].path) append_path(buffer, *items[i].path, drawing.paper_height, options);
      },
      out, context);
}

}  // namespace burin
