#include <burin/converters/load_plugins.h>
#include <burin/converters/read.h>
#include <burin/converters/write.h>
#include <burin/drawing/added_formats.h>
#include <burin/illustrate/style.h>
#include <burin/plugin/plugins.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <string_view>

namespace burin {
namespace {

bool is_style_group(std::string_view name) {
  const std::string group = std::string(name) + ".";
  return name == "base" || name == "name" || name == "strokes" ||
         std::ranges::any_of(style_keys(Style()),
                             [&](const StyleKey& key) { return key.name.starts_with(group); });
}

/// "writes svg", "reads .stl".
bool is_ours(std::string_view claim) {
  const std::string_view what = claim.substr(0, claim.find(' ')),
                         name = claim.substr(std::min(claim.size(), what.size() + 1));
  if (what == "reads") return is_own_suffix(name);
  if (what != "writes") return false;
  const auto added = added_formats();
  const bool again = std::ranges::find(added, name, &AddedFormat::name) != added.end();
  return is_own_format(name) || (!again && is_style_group(name));
}

}  // namespace

void load_plugins(bool again) {
  static std::once_flag reserved;
  std::call_once(reserved, [] { plugin::reserve(is_ours); });
  plugin::load_all(again);
}

}  // namespace burin
