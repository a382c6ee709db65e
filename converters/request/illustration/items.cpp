#include "key_row.h"

#include <charconv>
#include <map>

namespace burin::detail {

void take_title(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  out.request.title = in.text(value, path);
}

namespace {

const std::vector<KeyRow<KeptItem>>& item_rows() {
  static const std::vector<KeyRow<KeptItem>> rows = {
      text_row("name", "what the list calls it", &KeptItem::name),
      [] {
        KeyRow<KeptItem> row = text_row("select", "", &KeptItem::select);
        row.schema = selector();
        return row;
      }(),
  };
  return rows;
}

/// A name, or an object that says what has it, too.
KeptItem kept_item(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_object()) return {in.text(value, path), {}, true};
  check_members(item_rows(), in, value, path);
  if (value.empty()) {
    in.fail(path, "an item has a \"name\", or a \"select\" that names its part");
  }
  KeptItem kept;
  read_members(item_rows(), in, value, path, kept);
  return kept;
}

}  // namespace

int item_number(const KeyedFile& in, const std::string& text, const std::string& path) {
  int number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc() || end != last || text.front() == '0' || number < 1 ||
      number > kLargestItem) {
    in.fail(path, fmt::format("an item has a number from 1 to {}, not '{}'", kLargestItem, text));
  }
  return number;
}

/// Numbers and the names of what has them.
void take_items(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  if (!value.is_object()) in.fail(path, "\"items\" takes an object, {\"1\": \"bolt\", ...}");
  ItemNumbers& numbers = out.request.items;
  numbers.clear();
  std::map<std::string, std::string> known;
  for (const auto& [key, item] : value.items()) {
    const std::string at = path + "/" + key;
    const int number = item_number(in, key, at);
    KeptItem kept = kept_item(in, item, at);
    const auto [first, is_new] = known.try_emplace(kept.name, key);
    if (!is_new && !kept.name.empty()) {
      in.fail(at, fmt::format("'{}' has the number {} already", kept.name, first->second));
    }
    numbers[number] = std::move(kept);
  }
}

void take_parts_list(const KeyedFile& in, const Json& value, const std::string& path,
                     IllustrationFile& out) {
  const std::string given = in.text(value, path);
  if (given != "sheet") {
    in.fail(path, "\"parts_list\" takes \"sheet\"; `parts_list` writes files");
  }
  out.request.options["parts_list"] = {given};
}

Json items_schema() {
  Json item = object_schema(item_rows());
  item["minProperties"] = 1;
  return {{"description", "numbers of items and their names; kept from drawing to drawing"},
          {"type", "object"},
          {"propertyNames", {{"pattern", "^[1-9][0-9]{0,4}$"}}},
          {"additionalProperties", {{"anyOf", {{{"type", "string"}, {"minLength", 1}}, item}}}}};
}

Json write_items(const ItemNumbers& items) {
  Json all = Json::object();
  for (const auto& [number, item] : items) {
    all[std::to_string(number)] =
        item.select.empty() ? Json(item.name) : write_object(item_rows(), item);
  }
  return all;
}

}  // namespace burin::detail
