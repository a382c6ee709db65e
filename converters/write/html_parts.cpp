#include "html_parts.h"

#include <burin/drawing/color.h>
#include <burin/drawing/text.h>
#include <burin/drawing/title.h>
#include <burin/drawing/writers.h>

#include "html_page.h"

#include <filesystem>
#include <sstream>
#include <utility>

namespace burin::html {
namespace {

void append_item_row(Buffer& out, const DrawingItem& item) {
  append(out, fmt::format("<tr data-item=\"{}\" tabindex=\"-1\"><td>{}</td><td>{}</td><td>",
                          item.number, item.number, item.quantity()));
  if (rgb_of(item.color)) {
    append(out, fmt::format("<i style=\"background:{}\"></i>", escaped(item.color)));
  }
  const std::string file = std::filesystem::path(item.source).filename().string();
  const std::string parts = escaped(fmt::format("{}", fmt::join(item.things(), ";")));
  append(out, "<span title=\"" + parts + "\" data-parts=\"" + parts + "\">" + escaped(item.name) +
                  "</span></td><td title=\"" + escaped(item.source) + "\">" + escaped(file) +
                  "</td></tr>\n");
}

}  // namespace

std::string escaped(const std::string& text) {
  Buffer out;
  append_xml(out, text);
  return fmt::to_string(out);
}

std::string inline_svg(const Drawing& drawing, SvgOptions svg, const RunContext& context) {
  svg.merge = svg.flatten = false;  // the page asks elements for their items
  std::ostringstream out;
  write_svg(drawing, svg, out, context);
  const std::string text = std::move(out).str();
  return text.substr(text.find("<svg"));
}

std::string head(const std::string& title) {
  return std::string(kHead) + "<title>" + escaped(title) +
         "</title>\n<meta name=\"generator\" content=\"" + creator() + "\">\n<style>\n" + kStyle +
         "</style>\n</head>\n<body>\n";
}

std::string list_and_tail(std::span<const DrawingItem> items, const HtmlOptions& options) {
  Buffer rows;
  for (const DrawingItem& item : items) append_item_row(rows, item);
  return kListHead + fmt::to_string(rows) + kListTail + kScript + (options.live ? kLive : "") +
         kTail;
}

}  // namespace burin::html
