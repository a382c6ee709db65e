#include <burin/base/version.h>
#include <burin/drawing/bezier.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/ordered_text.h>
#include <burin/drawing/writers.h>

#include "svg_path.h"

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

/// A name as an XML id that no other group has.
std::string unique_id(std::string_view name, std::set<std::string>& taken) {
  std::string id;
  for (const char c : name) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    const bool later = (c >= '0' && c <= '9') || c == '-' || c == '.';
    if (id.empty() && !letter) id = "layer-";
    id.push_back(letter || later ? c : '_');
  }
  if (id.empty()) id = "layer";
  const std::string stem = id;
  for (int i = 2; !taken.insert(id).second; ++i) id = fmt::format("{}-{}", stem, i);
  return id;
}

std::string head(const Drawing& drawing) {
  Buffer out;
  append(out,
         "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" version=\"1.1\" width=\"");
  const double w = drawing.paper_width, h = drawing.paper_height;
  append_fixed(out, w, 3);
  append(out, "mm\" height=\"");
  append_fixed(out, h, 3);
  append(out, "mm\" viewBox=\"0 0 ");
  append_fixed(out, w, 3);
  out.push_back(' ');
  append_fixed(out, h, 3);
  append(out, "\">\n<desc>");
  append_xml(out,
             fmt::format("burin {}, style {}, seed {}", version(), drawing.style, drawing.seed));
  append(out, "</desc>\n");
  return fmt::to_string(out);
}

std::string layer_tag(const InkLayer& layer, const std::string& id, const SvgOptions& options) {
  Buffer out;
  append(out, fmt::format("<g id=\"{}\" inkscape:groupmode=\"layer\" inkscape:label=\"", id));
  append_xml(out, layer.name);
  append(out,
         "\" fill=\"none\" stroke=\"#000\" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
  if (layer.is_hidden()) {
    append(out, " stroke-dasharray=\"");
    append_fixed(out, options.dash, 3);
    out.push_back(' ');
    append_fixed(out, options.gap, 3);
    out.push_back('"');
  }
  append(out, ">\n");
  return fmt::to_string(out);
}

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
  std::string before = head(drawing);
  for (const InkLayer& group : groups) {
    const std::string id = unique_id(group.name, ids);
    before += layer_tag(group, id, options);
    for (const auto& [part, paths] : group.parts) {
      const std::string stem = part < 0 ? "none" : fmt::format("{}", part);
      before += part_tag(part, unique_id(id + "-" + stem, ids), drawing);
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

void append_stroke_width(Buffer& out, double width) {
  append(out, " stroke-width=\"");
  append_fixed(out, width, 3);
  out.push_back('"');
}

void append_polyline(Buffer& out, SvgPen& pen, const Path& p, double tolerance) {
  std::vector<Vec2> all = p.points;
  if (p.closed) all.push_back(all.front());
  std::vector<Vec2> kept;
  for (const std::size_t i : simplify(all, tolerance)) kept.push_back(all[i]);
  append(out, "<polyline");
  append_source(out, p);
  append_stroke_width(out, mean_width(p));
  append(out, " points=\"");
  pen.points(kept);
  append(out, "\"/>\n");
}

/// What rounding to the grid and writing nearly straight curves as lines may add, in paper mm.
constexpr double kWritingError = 0.002;

void append_path(Buffer& out, const Path& p, double paper_height, const SvgOptions& options) {
  SvgPen pen(out, paper_height);
  if (options.flatten_polylines) return append_polyline(out, pen, p, options.fit_tolerance);
  const double tolerance =
      std::max(options.fit_tolerance - kWritingError, 0.5 * options.fit_tolerance);
  const Ink ink = ink_of(p, tolerance);
  append(out, "<path");
  append_source(out, p);
  if (ink.filled) {
    append(out, " fill=\"#000\" stroke=\"none\"");
  } else {
    append_stroke_width(out, ink.width);
  }
  append(out, " d=\"");
  for (const auto& chain : ink.chains) pen.chain(chain, ink.filled || p.closed);
  if (ink.chains.front().empty()) pen.dot(p.points.front());
  append(out, "\"/>\n");
}

}  // namespace

void write_svg(const Drawing& drawing, const SvgOptions& options, std::ostream& out,
               const RunContext& context) {
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
