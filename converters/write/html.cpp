#include "html.h"

#include <burin/drawing/color.h>
#include <burin/drawing/text.h>
#include <burin/drawing/title.h>

#include "html_page.h"

#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
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

std::string escaped(const std::string& text) {
  Buffer out;
  append_xml(out, text);
  return fmt::to_string(out);
}

void append_row(Buffer& out, const DrawingItem& item) {
  append(out, fmt::format("<tr data-item=\"{}\" tabindex=\"-1\"><td>{}</td><td>{}</td><td>",
                          item.number, item.number, item.quantity()));
  if (rgb_of(item.color)) {
    append(out, fmt::format("<i style=\"background:{}\"></i>", escaped(item.color)));
  }
  const std::string file = std::filesystem::path(item.source).filename().string();
  append(out, escaped(item.name) + "</td><td title=\"" + escaped(item.source) + "\">" +
                  escaped(file) + "</td></tr>\n");
}

/// The element alone, without what a file of its own begins with.
std::string inline_svg(const Drawing& drawing, const WriteOptions& options,
                       const RunContext& context) {
  SvgOptions svg = options.svg;
  svg.merge = svg.flatten = false;  // the page asks elements for their items
  std::ostringstream out;
  write_svg(drawing, svg, out, context);
  const std::string text = std::move(out).str();
  return text.substr(text.find("<svg"));
}

}  // namespace

void write_html(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                const RunContext& context) {
  std::optional<Drawing> listed;
  if (drawing.items.empty()) {
    listed = drawing;
    listed->items = items_by_name(drawing);
  }
  const Drawing& shown = listed ? *listed : drawing;
  Buffer head, rows;
  append(head, html::kHead);
  append(head, "<title>" + escaped(title_of(shown)) +
                   "</title>\n<meta name=\"generator\" content=\"" + creator() + "\">\n<style>\n");
  append(head, html::kStyle);
  append(head, "</style>\n</head>\n<body>\n<main>\n");
  for (const DrawingItem& item : shown.items) append_row(rows, item);
  out << fmt::to_string(head) << inline_svg(shown, options, context) << html::kListHead
      << fmt::to_string(rows) << html::kListTail << html::kScript << html::kTail;
}

}  // namespace burin
