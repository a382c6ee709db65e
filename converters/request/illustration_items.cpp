#include "illustration_keyed.h"

#include <charconv>
#include <map>

namespace burin::detail {

void take_title(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  out.request.title = in.text(value, path);
}

namespace {

/// A name, or an object that says what has it, too.
KeptItem kept_item(const KeyedFile& in, const Json& value, const std::string& path) {
  if (!value.is_object()) return {in.text(value, path), {}, true};
  in.check_object(value, path, kItemKeys);
  if (!value.contains("name") && !value.contains("select")) {
    in.fail(path, "an item has a \"name\", or a \"select\" that names its part");
  }
  KeptItem kept;
  if (value.contains("name")) kept.name = in.text(value["name"], path + "/name");
  if (value.contains("select")) kept.select = in.text(value["select"], path + "/select");
  return kept;
}

}  // namespace

/// Numbers and the names of what has them.
void take_items(const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) {
  if (!value.is_object()) in.fail(path, "\"items\" takes an object, {\"1\": \"bolt\", ...}");
  ItemNumbers& numbers = out.request.items;
  numbers.clear();
  std::map<std::string, std::string> known;
  for (const auto& [key, item] : value.items()) {
    const std::string at = path + "/" + key;
    int number = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
    if (error != std::errc() || end != key.data() + key.size() || number < 1 ||
        number > kLargestItem) {
      in.fail(at, fmt::format("an item has a number from 1 to {}, not '{}'", kLargestItem, key));
    }
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

}  // namespace burin::detail
