#include <burin/converters/messages.h>
#include <burin/converters/request.h>

#include "make_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

/// Whether both styles have the same value.
bool has_same(std::string_view key, const Style& a, const Style& b) {
  const auto value = [&](const Style& style) {
    const std::vector<StyleKey> keys = style_keys(style);
    const auto found = std::ranges::find(keys, key, &StyleKey::name);
    return found == keys.end() ? std::nullopt : std::optional(found->value);
  };
  const auto of_a = value(a);
  return of_a && of_a == value(b);
}

/// Whether a built-in style has that value and does not use it either, as `burin styles --show`
/// prints it: who starts from its text did not ask for it.
bool is_idle_in_builtin(std::string_view key, const Style& style) {
  return std::ranges::any_of(builtin_styles(), [&](const StyleInfo& info) {
    const Style builtin = builtin_style(info.name);
    return has_same(key, style, builtin) && !why_unused(key, builtin, {}, {.legend = true}).empty();
  });
}

/// Parts as this drawing has them, and as its styles would draw others.
std::vector<PartStyle> with_other_parts(const DrawPlan& plan) {
  std::vector<PartStyle> parts = plan.illustrate.part_styles;
  for (PartStyle& part : parts) {
    part.drawn = part.hatched = true;
    part.transparent = false;
  }
  parts.emplace_back();
  for (const Look& look : plan.looks) parts.push_back({.style = look.style});
  return parts;
}

/// A style file is for many drawings: no message names what has no effect only because of this
/// one's view, legend or glass. Keys that lack the same share a message.
void add_written(const DrawPlan& plan, Diagnostics& notes) {
  const std::vector<PartStyle> parts = with_other_parts(plan);
  std::map<std::pair<std::string, std::string>, std::vector<std::string>> lacking;
  for (const WrittenKeys& written : plan.written_keys) {
    for (const std::string& key : written.keys) {
      const std::string why = written.of_parts
                                  ? why_unused_in_parts(key, *written.of_parts, plan.style)
                                  : why_unused(key, plan.style, parts, {.legend = true});
      if (why.empty() || is_idle_in_builtin(key, written.of_parts.value_or(plan.style))) continue;
      std::vector<std::string>& keys = lacking[{written.source, why}];
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    }
  }
  for (const auto& [where, keys] : lacking) {
    const auto& [source, why] = where;
    notes.add(Severity::Warning, "option.unused", static_cast<std::int64_t>(keys.size()),
              fmt::format("{}style key{} {} {} no effect{}", source.empty() ? "" : source + ": ",
                          keys.size() > 1 ? "s" : "", fmt::join(keys, ", "),
                          keys.size() > 1 ? "have" : "has", why));
  }
}

}  // namespace

std::vector<AskedKey> asked_keys(const DrawRequest& r, const Style& named, const DrawPlan& plan) {
  std::vector<AskedKey> keys;
  if (r.has("light") && plan.style.tone.light != named.tone.light) {
    keys.push_back({called("light", plan.spelling), "tone.light"});
  }
  for (const std::string& key : plan.style_keys) {
    if (!has_same(key, plan.style, named)) keys.push_back({"style key " + key, key});
  }
  return keys;
}

WrittenKeys written_in(const LoadedStyle& read, const Style& start, const Style& used) {
  WrittenKeys written{read.source, keys_written(read.text, read.source, start)};
  std::erase_if(written.keys,
                [&](const std::string& key) { return !has_same(key, read.style, used); });
  return written;
}

Diagnostics unused_keys(const DrawPlan& plan, const KeySurroundings& around) {
  Diagnostics notes;
  for (const auto& [called, key] : plan.asked_keys) {
    const std::string why = why_unused(key, plan.style, plan.illustrate.part_styles, around);
    if (why.empty()) continue;
    notes.add(Severity::Warning, "option.unused", 1, called + " has no effect" + why);
  }
  add_written(plan, notes);
  return notes;
}

}  // namespace burin::detail
