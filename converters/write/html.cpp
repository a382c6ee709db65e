#include "html.h"

#include <burin/drawing/title.h>

#include "html_parts.h"
#include "own_formats.h"

#include <map>
#include <optional>
#include <ostream>
#include <string>

namespace burin {
namespace {

/// An item a name, for drawings that come without.
std::vector<DrawingItem> items_by_name(const Drawing& drawing) {
  std::vector<DrawingItem> items;
  std::map<std::string, std::size_t> known;
  for (const DrawingPart& part : drawing.parts) {
    const auto [it, is_new] = known.try_emplace(part.name, items.size());
    if (is_new) {
      const std::string name = part.name.empty() ? fmt::format("part {}", part.id) : part.name;
      items.push_back({static_cast<int>(items.size()) + 1, name, {}, part.color, part.source});
    }
    items[it->second].parts.push_back(part.id);
  }
  return items;
}

}  // namespace

void write_html(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                const RunContext& context) {
  std::optional<Drawing> listed;
  if (drawing.items.empty()) {
    listed = drawing;
    listed->items = items_by_name(drawing);
  }
  // The list points to the groups of parts.
  SvgOptions svg = options.svg;
  svg.order = LineOrder::Drawing;
  const Drawing& shown = listed ? *listed : drawing;
  out << html::head(title_of(shown)) << "<main>\n"
      << html::inline_svg(shown, svg, context) << html::list_and_tail(shown.items, options.html);
}

namespace detail {

Format html_format() {
  return {.name = "html",
          .keys = {},
          .write = write_html,
          .lists_items = true,
          .other_suffixes = {"htm"}};
}

}  // namespace detail
}  // namespace burin
