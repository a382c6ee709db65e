#include <burin/base/parallel.h>
#include <burin/drawing/ordered_text.h>

#include "svg_path.h"
#include "svg_tags.h"

#include <cmath>
#include <ostream>
#include <utility>

namespace burin {
namespace {

/// A path with its ink; the tags before it. The last item has no path.
struct Item {
  std::string before;
  const Path* path = nullptr;
  Ink ink;
};

/// The layer's paths by pen, from thin to thick; 0 = filled outlines. Pens that differ by less than
/// what is written are one.
std::map<double, std::vector<Item>> by_pen(const InkLayer& layer, const SvgOptions& options,
                                           const RunContext& context) {
  std::vector<Item> items;
  for (const auto& [part, paths] : layer.parts) {
    for (const Path* path : paths) items.push_back({{}, path, {}});
  }
  parallel_for(items.size(), 64, [&](std::size_t begin, std::size_t end) {
    context.check();
    for (std::size_t i = begin; i < end; ++i) {
      items[i].ink = ink_of(*items[i].path, curve_tolerance(options));
    }
  });
  std::map<double, std::vector<Item>> pens;
  for (Item& item : items) {
    const double width = item.ink.filled ? 0 : std::round(item.ink.width * 1e3) * 1e-3;
    pens[width].push_back(std::move(item));
  }
  return pens;
}

std::string pen_tag(double width) {
  Buffer out;
  append(out, "<path");
  if (width > 0) {
    append_pen(out, width);
  } else {
    append(out, " fill=\"#000\" stroke=\"none\"");
  }
  append(out, " d=\"");
  return fmt::to_string(out);
}

void append_subpath(Buffer& out, const Item& item, double paper_height) {
  SvgPen pen(out, paper_height);
  for (const auto& chain : item.ink.chains) pen.chain(chain, item.ink.filled || item.path->closed);
  if (item.ink.chains.front().empty()) pen.dot(item.path->points.front());
}

}  // namespace

void write_merged_svg(const Drawing& drawing, const SvgOptions& options, std::ostream& out,
                      const RunContext& context) {
  std::vector<Item> items;
  std::set<std::string> ids;
  std::string before = svg_head(drawing);
  for (const InkLayer& layer : ink_layers(drawing)) {
    before += svg_layer_tag(layer, svg_id(layer.name, ids), options);
    for (auto& [width, paths] : by_pen(layer, options, context)) {
      before += pen_tag(width);
      for (Item& item : paths) {
        item.before = std::exchange(before, {});
        items.push_back(std::move(item));
      }
      before = "\"/>\n";
    }
    before += "</g>\n";
  }
  items.push_back({before + "</svg>\n", nullptr, {}});
  write_ordered(
      items.size(), [&](std::size_t i) { return items[i].path ? items[i].path->points.size() : 0; },
      [&](std::size_t i, Buffer& buffer) {
        append(buffer, items[i].before);
        if (items[i].path) append_subpath(buffer, items[i], drawing.paper_height);
      },
      out, context);
}

}  // namespace burin
