#include "dxf.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/drawing/font.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/join.h>
#include <burin/drawing/ordered_text.h>

#include "dxf_entities.h"
#include "dxf_frame.h"
#include "own_formats.h"

#include <algorithm>
#include <deque>
#include <map>
#include <ostream>

namespace burin {
namespace {

using dxf::Fixed;
using dxf::Groups;
using dxf::Item;

/// The weight that most paths of a layer have; the thinner one of equals.
int common_weight(const InkLayer& layer) {
  std::map<int, std::size_t> counts;
  for (const auto& [part, paths] : layer.parts) {
    for (const Path* path : paths) ++counts[dxf::weight_of(*path)];
  }
  int best = 25;
  std::size_t most = 0;
  for (const auto& [weight, count] : counts) {
    if (count <= most) continue;
    most = count;
    best = weight;
  }
  return best;
}

/// Dashes of a layer's own are the nearest of the two kinds that there are.
std::string_view linetype_of(const InkLayer& layer) {
  if (!layer.own_dashes.empty()) return layer.own_dashes.size() < 4 ? dxf::kDashed : dxf::kDashDot;
  if (layer.name == kHiddenLayer) return dxf::kDashed;
  if (has_long_dashes(layer.name)) return dxf::kLongDashDot;
  return layer.name == kTrailLayer ? dxf::kDashDot : dxf::kContinuous;
}

dxf::Frame frame_of(const Drawing& drawing, const std::vector<Item>& items,
                    const SvgOptions& options) {
  dxf::Frame frame;
  frame.sheet = {drawing.paper_width, drawing.paper_height};
  frame.high = frame.sheet;
  frame.dashes = InkLayer{std::string(kHiddenLayer), {}}.dashes(options.dashes);
  frame.dash_dots = InkLayer{std::string(kTrailLayer), {}}.dashes(options.dashes);
  frame.long_dash_dots = InkLayer{std::string(kCentreLayer), {}}.dashes(options.dashes);
  bool first = true;
  const auto add = [&](Vec2 p) {
    frame.low = first ? p : glm::min(frame.low, p);
    frame.high = first ? p : glm::max(frame.high, p);
    first = false;
  };
  for (const Item& item : items) {
    if (item.text) {
      const Box2 box = text_box(*item.text);
      add(box.min), add(box.max);
      continue;
    }
    if (item.area) {
      for (const std::vector<Vec2>& ring : item.area->rings) {
        for (const Vec2& p : ring) add(p);
      }
      continue;
    }
    for (const Vec2& p : item.path->points) add(p);
  }
  return frame;
}

void write(const Buffer& text, std::ostream& out) {
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace

void write_dxf(const Drawing& drawing, const WriteOptions& given, std::ostream& out,
               const RunContext& context) {
  const dxf::Chosen options{values_in<DxfOptions>(given.formats), given.svg};
  const std::vector<InkLayer> layers = ink_layers(drawing);
  std::vector<dxf::LayerRow> rows;
  rows.reserve(layers.size() + 1);  // items point to them
  std::vector<Item> items;
  if (const std::vector<const Area*> areas = painted_areas(drawing); !areas.empty()) {
    rows.push_back({dxf::symbol_name("areas", rows), dxf::kContinuous});
    for (const Area* area : areas) items.push_back({.layer = &rows.back(), .area = area});
  }
  std::deque<JoinedPaths> joined;
  Vec2 pen(0);
  for (const InkLayer& layer : layers) {
    rows.push_back({dxf::symbol_name(layer.name, rows), linetype_of(layer), common_weight(layer)});
    // The ink of a whole drawing is that of the program which shows it; lines and layers that have
    // a colour of their own keep it.
    if (const auto color = rgb_of(layer.color)) rows.back().color = dxf::nearest_color(*color);
    std::vector<const Path*> all;
    const bool travels = options.dxf.order == LineOrder::Travel;
    for (const auto& [part, paths] : layer.parts) {
      std::vector<const Path*> of_part = paths;
      if (options.dxf.arcs && !travels) {
        const auto wanted = [&](const Path& ring) { return dxf::is_whole_arc(ring, options); };
        of_part = joined.emplace_back(join_rings(paths, wanted)).paths;
      }
      all.insert(all.end(), of_part.begin(), of_part.end());
    }
    if (travels) all = joined.emplace_back(in_travel_order(all, pen, context)).paths;
    for (const Path* path : all) items.push_back({path, &rows.back()});
    for (const Text* text : layer.texts) {
      items.push_back({.layer = &rows.back(), .text = text});
    }
  }
  dxf::Frame frame = frame_of(drawing, items, options.svg);
  constexpr std::size_t kGrain = 64;
  const auto fit = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (items[i].path) items[i].pieces = dxf::pieces_of(*items[i].path, options);
    }
  };
  parallel_for(items.size(), kGrain, fit, &context);
  frame.next_handle = static_cast<std::uint64_t>(Fixed::FirstLayer) + rows.size();
  for (Item& item : items) {
    item.handle = frame.next_handle;
    frame.next_handle += item.entities();
  }
  Buffer text;
  dxf::append_head(text, frame, rows);
  write(text, out);
  write_ordered(
      items.size(), [&](std::size_t i) { return items[i].path ? items[i].path->points.size() : 1; },
      [&](std::size_t i, Buffer& buffer) {
        Groups groups(buffer);
        dxf::append(groups, items[i], options);
      },
      out, context);
  text.clear();
  dxf::append_tail(text, frame);
  write(text, out);
}

namespace detail {

Format dxf_format() { return {"dxf", {"dxf."}, write_dxf}; }

}  // namespace detail
}  // namespace burin
