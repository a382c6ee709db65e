#include <burin/drawing/parts_list.h>
#include <burin/drawing/text.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace burin {
namespace {

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

}  // namespace

std::vector<std::string> DrawingItem::things() const {
  std::vector<std::string> out;
  std::ranges::unique_copy(selectors, std::back_inserter(out));
  return out;
}

std::string parts_list_csv(std::span<const DrawingItem> items) {
  std::string out = "number,name,quantity,colour,source,parts\r\n";
  for (const DrawingItem& item : items) {
    out += fmt::format("{},{},{},{},{},{}\r\n", item.number, csv_field(item.name), item.quantity(),
                       csv_field(item.color), csv_field(item.source),
                       csv_field(fmt::format("{}", fmt::join(item.things(), ";"))));
  }
  return out;
}

std::string parts_list_json(std::span<const DrawingItem> items) {
  Buffer out;
  append(out, "{\n  \"items\": [");
  for (std::size_t i = 0; i < items.size(); ++i) {
    const DrawingItem& item = items[i];
    fmt::format_to(fmt::appender(out), "{}\n    {{\"number\": {}, \"name\": ", i > 0 ? "," : "",
                   item.number);
    append_json(out, item.name);
    fmt::format_to(fmt::appender(out), ", \"quantity\": {}, \"colour\": ", item.quantity());
    append_json(out, item.color);
    append(out, ", \"source\": ");
    append_json(out, item.source);
    append(out, ", \"parts\": ");
    append_json(out, item.things());
    append(out, "}");
  }
  append(out, items.empty() ? "]\n}\n" : "\n  ]\n}\n");
  return fmt::to_string(out);
}

}  // namespace burin
