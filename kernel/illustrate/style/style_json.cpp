#include <burin/base/error.h>
#include <burin/illustrate/style.h>
#include <burin/illustrate/unused_keys.h>
#include <burin/options/json_lines.h>

#include "style_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;

/// A value as the text that `set_style_key` takes.
std::string to_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string list;
  for (const Json& element : value) list += (list.empty() ? "" : ",") + element.dump();
  return list;
}

Json to_json(const OptionValue& value, const Option& option) {
  const std::string text = value_text(option, value);
  if (std::holds_alternative<Vec3>(value)) return Json::parse("[" + text + "]");
  if (std::holds_alternative<double>(value) || std::holds_alternative<WholeRange>(option.takes) ||
      text == "true" || text == "false") {
    return Json::parse(text);
  }
  return text;
}

/// "hatch.taper" as its group and the name in it.
std::pair<std::string, std::string> parted(const std::string& key) {
  const std::size_t dot = key.find('.');
  return {key.substr(0, dot), key.substr(dot + 1)};
}

/// Whether keys of styles begin so.
bool is_group(const std::string& name) {
  return std::ranges::any_of(detail::style_rows(), [&](const detail::StyleRow& row) {
    return row.name.starts_with(name + ".");
  });
}

Json parse(std::string_view text, const std::string& source) {
  return parse_json_object<Json>(
      text, source, "style file",
      "a style file is one JSON object, {\"base\": ..., \"line.outer\": ...}");
}

/// Reads a style's members into `style`, naming file and line in errors.
class Reader {
 public:
  Reader(Style& style, std::string_view text, const std::string& source, const Style* whole)
      : style_(style), lines_(text), source_(source), whole_(whole) {}

  /// All members but those about stroke kinds.
  void object(const Json& json, const std::string& group) {
    for (const auto& [key, value] : json.items()) {
      const std::string full = group.empty() ? key : group + "." + key;
      if (group.empty() && (key == "base" || key == "strokes" || setting_rank(key) > 0)) continue;
      if (group.empty() && key == "name") {
        at(group, key, [&, &v = value] { name(v); });
      } else if (value.is_object() && group.empty()) {
        if (!is_group(key)) at(group, key, [&, &k = key] { detail::find_row(k); });
        object(value, key);
      } else {
        at(group, key, [&, &v = value] { set(full, to_text(v)); });
      }
    }
  }

  /// The list "strokes", then keys like "strokes.2.taper". What a kind does not say it has from the
  /// members before.
  void strokes(const Json& json) {
    if (json.contains("strokes")) list(json["strokes"]);
    for (const int rank : {1, 2}) {
      for (const auto& [key, value] : json.items()) {
        if (setting_rank(key) != rank) continue;
        at("", key, [&, &k = key, &v = value] { set_style_key(style_, k, to_text(v)); });
      }
    }
  }

  void base(const Json& json) {
    if (!json.contains("base")) return;
    at("", "base", [&] { style_ = builtin_style(to_text(json["base"])); });
  }

 private:
  void set(const std::string& key, const std::string& text) {
    if (!whole_) return set_style_key(style_, key, text);
    const detail::StyleRow& row = detail::find_row(key);
    const OptionValue before = row.get(style_);
    set_style_key(style_, key, text);
    const OptionValue value = row.get(style_);
    if (!row.of_whole || value == before || value == row.get(*whole_)) return;
    const std::string instead = detail::key_of_parts(key);
    throw UsageError(
        fmt::format("style key '{}' holds for the whole drawing and cannot differ by part: {}", key,
                    instead.empty() ? "leave it out here, or set it for the drawing"
                                    : fmt::format("parts have '{}' instead", instead)));
  }

  void list(const Json& json) {
    at("", "strokes", [&] {
      if (!json.is_array()) throw UsageError("style key 'strokes' takes a list of stroke kinds");
      style_.strokes.clear();
    });
    for (std::size_t i = 0; i < json.size(); ++i) {
      const std::string group = fmt::format("strokes/{}", i);
      at("strokes", std::to_string(i), [&] {
        if (!json[i].is_object())
          throw UsageError("a stroke kind is an object, {\"placing\": ...}");
        if (i > 0) style_.strokes.push_back(detail::next_kind(style_));
      });
      const auto set = [&](const std::string& path, const std::string& key, const Json& value) {
        at(group, path, [&] {
          set_style_key(style_, fmt::format("strokes.{}.{}", i + 1, key), to_text(value));
        });
      };
      if (json[i].contains("kind")) set("kind", "kind", json[i]["kind"]);
      for (const auto& [key, value] : json[i].items()) {
        if (key == "kind") continue;
        if (key == "tone" && value.is_object()) {
          for (const auto& [name, of_tone] : value.items()) {
            set("tone/" + name, "tone." + name, of_tone);
          }
        } else {
          set(key, key, value);
        }
      }
    }
  }

  void name(const Json& value) {
    if (!value.is_string()) throw UsageError("style key 'name' takes text");
    style_.name = value.get<std::string>();
  }

  template <class F>
  void at(const std::string& group, const std::string& key, const F& read) const {
    try {
      read();
    } catch (const UsageError& e) {
      const std::string path = (group.empty() ? "/" : "/" + group + "/") + key;
      throw UsageError(fmt::format("{}:{}: {}", source_, lines_.line(path), e.what()));
    }
  }

  Style& style_;
  JsonLines lines_;
  const std::string& source_;
  const Style* whole_;
};

}  // namespace

Style parse_style(std::string_view json, const std::string& source) {
  return parse_style(json, source, builtin_style("technical"));
}

Style parse_style(std::string_view json, const std::string& source, const Style& start,
                  const Style* whole) {
  const Json parsed = parse(json, source);
  Style style = start;
  Reader reader(style, json, source, whole);
  reader.base(parsed);
  style.name = std::filesystem::path(source).stem().string();
  reader.object(parsed, "");
  reader.strokes(parsed);
  try {
    check_style(style);
  } catch (const UsageError& e) {
    throw UsageError(fmt::format("{}: {}", source, e.what()));
  }
  return style;
}

namespace {

/// Adds the keys of an object, and of those in it as one group.
void add_keys(const Json& json, const std::string& before, std::vector<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    if (key == "kind" || (before.empty() && (key == "base" || key == "name" || key == "strokes")))
      continue;
    if (value.is_object()) {
      add_keys(value, before + key + ".", keys);
    } else {
      keys.push_back(detail::row_of_key(before + key));
    }
  }
}

}  // namespace

std::vector<std::string> keys_written(std::string_view json, const std::string& source,
                                      const Style& start) {
  const Json parsed = parse(json, source);
  const Style style = parse_style(json, source, start);
  std::vector<std::string> keys;
  add_keys(parsed, "", keys);
  const Json kinds = parsed.value("strokes", Json::array());
  for (std::size_t i = 0; i < kinds.size(); ++i)
    add_keys(kinds[i], fmt::format("strokes.{}.", i + 1), keys);
  const Style base = parsed.contains("base") ? builtin_style(to_text(parsed["base"])) : start;
  const auto rows = detail::all_rows_of(style);
  std::erase_if(keys, [&](const std::string& key) {
    const auto row = std::ranges::find(rows, key, &detail::StyleRow::name);
    if (row == rows.end()) return true;
    const auto kind = detail::kind_key(key);
    const bool has_kind = !kind || kind->number <= stroke_kind_count(base);
    return has_kind && row->get(style) == row->get(base);
  });
  return keys;
}

std::string style_to_json(const Style& style) {
  Json json;
  json["name"] = style.name;
  for (const detail::StyleRow& row : detail::style_rows()) {
    const auto [group, name] = parted(row.name);
    json[group][name] = to_json(row.get(style), row);
  }
  if (!style.strokes.empty())
    json["strokes"] = Json::array({Json::object()});  // the first is above
  for (const StrokeKind& kind : style.strokes) {
    Json& members = json["strokes"].emplace_back();
    for (const detail::KindRow& row : detail::kind_rows()) {
      members[row.name] = to_json(row.get(kind), row);
    }
  }
  return json.dump(2) + "\n";
}

namespace {

Json kinds_schema() {
  Json kinds = Json::array(), members, tone;
  for (const StyleInfo& kind : stroke_kinds()) kinds.push_back(kind.name);
  members["kind"] = {{"description", "the kind whose values hold for all other keys"},
                     {"enum", std::move(kinds)}};
  for (const detail::KindRow& row : detail::kind_rows()) {
    const Json value = Json::parse(value_schema(row));
    members[row.name] = value;
    if (row.name.starts_with("tone.")) tone[row.name.substr(row.name.find('.') + 1)] = value;
  }
  members["tone"] = {
      {"type", "object"}, {"additionalProperties", false}, {"properties", std::move(tone)}};
  return {
      {"description",
       "kinds of strokes, drawn over each other in this order; the first changes hatch and "
       "tone, the others begin as these are"},
      {"type", "array"},
      {"maxItems", kMostStrokeKinds},
      {"items",
       {{"type", "object"}, {"additionalProperties", false}, {"properties", std::move(members)}}}};
}

}  // namespace

std::string style_schema() {
  Json bases = Json::array(), properties;
  for (const StyleInfo& style : builtin_styles()) bases.push_back(style.name);
  properties["base"] = {{"description", "the built-in style whose values hold for all other keys"},
                        {"enum", std::move(bases)}};
  properties["name"] = {{"type", "string"}};
  for (const detail::StyleRow& row : detail::style_rows()) {
    const auto [group, name] = parted(row.name);
    const Json value = Json::parse(value_schema(row));
    Json& members = properties[group];
    members["type"] = "object";
    members["additionalProperties"] = false;
    members["properties"][name] = value;
    properties[row.name] = value;  // dotted keys and groups may be mixed
  }
  properties["strokes"] = kinds_schema();
  properties["tone"]["description"] = "the light of the first kind of strokes";
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Style of Burin"},
                    {"type", "object"},
                    {"properties", std::move(properties)},
                    {"additionalProperties", false}};
  return schema.dump(2) + "\n";
}

}  // namespace burin
