#include <burin/base/box.h>
#include <burin/base/parallel.h>
#include <burin/drawing/font.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/join.h>
#include <burin/drawing/ordered_text.h>

#include "svg_areas.h"
#include "svg_path.h"
#include "svg_tags.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <span>
#include <type_traits>
#include <utility>

namespace burin {
namespace {

/// Qt reads the first 32,767 elements of a path and leaves out the rest without a word.
constexpr std::size_t kMostElements = 30'000;
/// Longer paths are parted unseen: the outline of one costs time that grows with its square.
constexpr std::size_t kMostPoints = 10'000;

/// The ink of a path, or of a stretch of it; the tags before it. The last item has no ink.
struct MergedItem {
  std::string before;
  Ink ink;
  bool close = false;
  Vec2 first{0};
  std::size_t cost = 0;
  std::size_t elements = 0;
};

/// By colour, which is empty where it is that of the layer, and width.
using Pens = std::map<std::pair<std::string, double>, std::vector<MergedItem>>;

MergedItem item_of(const Path& path, const SvgOptions& options) {
  MergedItem item{{}, ink_of(path, curve_tolerance(options)), false, path.points.front(), 0, 1};
  item.close = item.ink.filled || path.closed;
  item.cost = path.points.size();
  for (const auto& chain : item.ink.chains) item.elements += path_elements(chain, item.close);
  return item;
}

/// The points from `begin` to `end` as an open path.
Path stretch(const Path& path, std::size_t begin, std::size_t end) {
  Path part = without_points(path);
  const auto cut = [&](const auto& from) {
    return std::remove_cvref_t<decltype(from)>(from.begin() + static_cast<std::ptrdiff_t>(begin),
                                               from.begin() + static_cast<std::ptrdiff_t>(end));
  };
  part.points = cut(path.points);
  part.width = path.width.size() == path.points.size() ? cut(path.width) : path.width;
  return part;
}

/// A path as items that no reader cuts short: one, unless it has too many elements by itself. Areas
/// overlap by a segment where they are parted, so that their noses do not show.
void append_items(const Path& path, const SvgOptions& options, std::vector<MergedItem>& items) {
  if (path.points.size() <= kMostPoints) {
    MergedItem whole = item_of(path, options);
    if (whole.elements <= kMostElements || path.points.size() < 4) {
      items.push_back(std::move(whole));
      return;
    }
  }
  Path open = stretch(path, 0, path.points.size());
  if (path.closed) {
    open.points.push_back(open.points.front());
    if (open.width.size() > 1) open.width.push_back(open.width.front());
  }
  const std::size_t middle = open.points.size() / 2;
  append_items(stretch(open, 0, middle + (has_varying_width(path) ? 2 : 1)), options, items);
  append_items(stretch(open, middle, open.points.size()), options, items);
}

/// The layer's paths, those that close together as one. `pen`: where a pen stands before and then.
JoinedPaths lines_of(const InkLayer& layer, const SvgOptions& options, Vec2& pen,
                     const RunContext& context) {
  std::vector<const Path*> all;
  for (const auto& [part, paths] : layer.parts) all.insert(all.end(), paths.begin(), paths.end());
  if (options.order == LineOrder::Travel) return in_travel_order(all, pen, context);
  if (layer.name == kOutlineLayer) return join_rings(all);
  JoinedPaths as_given;
  as_given.paths = std::move(all);
  return as_given;
}

/// The layer's ink by pen, each colour from thin to thick; 0 = filled outlines. Pens that differ by
/// less than what is written are one.
Pens by_pen(std::span<const Path* const> paths, const SvgOptions& options,
            const RunContext& context) {
  std::vector<std::vector<MergedItem>> items(paths.size());
  parallel_for(items.size(), 64, [&](std::size_t begin, std::size_t end) {
    context.check();
    for (std::size_t i = begin; i < end; ++i) append_items(*paths[i], options, items[i]);
  });
  Pens pens;
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (MergedItem& item : items[i]) {
      const double width = item.ink.filled ? 0 : std::round(item.ink.width * 1e3) * 1e-3;
      pens[{paths[i]->color, width}].push_back(std::move(item));
    }
  }
  return pens;
}

/// `color`: that of the pen where it is not that of the layer.
std::string pen_tag(const std::string& color, double width, std::string_view ink) {
  Buffer out;
  append(out, "<path");
  if (width > 0) {
    if (!color.empty()) append(out, fmt::format(" stroke=\"{}\"", svg_ink(color)));
    append_pen(out, width);
  } else {
    append(out, fmt::format(" fill=\"{}\" stroke=\"none\"",
                            color.empty() ? ink : std::string_view(color)));
  }
  append(out, " d=\"");
  return fmt::to_string(out);
}

/// Paths of one pen, parted before they have too many elements; several of them in a group, for
/// programs that are slow where an element has many others beside it.
void append_pen_items(const std::string& tag, std::vector<MergedItem>& of_pen, std::string& before,
                      std::vector<MergedItem>& items) {
  std::size_t all = 0, here = 0;
  for (const MergedItem& item : of_pen) all += item.elements;
  const bool several = all > kMostElements;
  if (several) before += "<g>\n";
  before += tag;
  for (MergedItem& item : of_pen) {
    if (here + item.elements > kMostElements && here > 0) {
      before += "\"/>\n" + tag;
      here = 0;
    }
    here += item.elements;
    item.before = std::exchange(before, {});
    items.push_back(std::move(item));
  }
  before = several ? "\"/>\n</g>\n" : "\"/>\n";
}

void append_subpath(Buffer& out, const MergedItem& item, double paper_height) {
  SvgPen pen(out, paper_height);
  for (const auto& chain : item.ink.chains) pen.chain(chain, item.close);
  if (item.ink.chains.front().empty()) pen.dot(item.first);
}

/// Left, top, right and bottom of all that is painted on the sheet, in mm from its top left, for
/// programs that trim the picture; empty without ink.
std::string ink_box(const Drawing& drawing, const std::vector<InkLayer>& layers) {
  Box2 box;
  for (const InkLayer& layer : layers) {
    for (const Text* text : layer.texts) box.add(text_box(*text));
    for (const auto& [part, paths] : layer.parts) {
      for (const Path* path : paths) {
        const double reach = path->width.empty()
                                 ? 0
                                 : 0.5 * *std::max_element(path->width.begin(), path->width.end());
        for (const Vec2 p : path->points) {
          box.add(p - Vec2(reach));
          box.add(p + Vec2(reach));
        }
      }
    }
  }
  for (const Area* area : painted_areas(drawing)) {
    for (const std::vector<Vec2>& ring : area->rings) {
      for (const Vec2 p : ring) box.add(p);
    }
  }
  if (box.empty()) return {};
  return fmt::format(" data-ink=\"{:.3f} {:.3f} {:.3f} {:.3f}\"", box.min.x,
                     drawing.paper_height - box.max.y, box.max.x, drawing.paper_height - box.min.y);
}

/// Areas of colour, below all lines.
std::string areas_group(const Drawing& drawing, SvgIds& ids) {
  const std::vector<const Area*> areas = painted_areas(drawing);
  if (areas.empty()) return {};
  Buffer out;
  append(out,
         fmt::format("<g id=\"{}\" stroke=\"none\" fill-rule=\"evenodd\">\n", ids.make("areas")));
  for (const Area* area : areas) {
    append(out, "<path");
    append_area_fill(out, *area);
    append(out, " d=\"");
    append_area_rings(out, *area, drawing.paper_height);
    append(out, "\"/>\n");
  }
  append(out, "</g>\n");
  return fmt::to_string(out);
}

}  // namespace

void write_merged_svg(const Drawing& drawing, const SvgOptions& options, std::ostream& out,
                      const RunContext& context) {
  std::vector<MergedItem> items;
  SvgIds ids(options.id_prefix);
  const std::vector<InkLayer> layers = ink_layers(drawing);
  std::string before = svg_head(drawing, ink_box(drawing, layers));
  before += areas_group(drawing, ids);
  Vec2 pen(0);
  for (const InkLayer& layer : layers) {
    const std::string ink = svg_ink(ink_color(layer, drawing));
    before += svg_layer_tag(layer, ids.make(layer.name), ink, options);
    const JoinedPaths lines = lines_of(layer, options, pen, context);
    for (auto& [pen_at, of_pen] : by_pen(lines.paths, options, context)) {
      append_pen_items(pen_tag(pen_at.first, pen_at.second, ink), of_pen, before, items);
    }
    for (const Text* text : layer.texts) {
      before += svg_text(*text, drawing.paper_height, ink, options);
    }
    before += "</g>\n";
  }
  items.push_back({before + "</svg>\n", {}, false, {}, 0, 0});
  write_ordered(
      items.size(), [&](std::size_t i) { return items[i].cost; },
      [&](std::size_t i, Buffer& buffer) {
        append(buffer, items[i].before);
        if (items[i].cost > 0) append_subpath(buffer, items[i], drawing.paper_height);
      },
      out, context);
}

}  // namespace burin
