#include <burin/converters/illustration.h>

#include "draw_options.h"
#include "keys.h"
#include "rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace burin {

namespace fs = std::filesystem;
using detail::Json;

namespace detail {

Json written_value(const RequestOption& option, const std::string& text) {
  const std::string_view kind = kind_of(option.option);
  if (kind == "number" || kind == "whole" || kind == "flag" ||
      option.python.find("float") != std::string::npos) {
    Json value = Json::parse(text, nullptr, false);
    if (!value.is_discarded()) return value;
  }
  if (kind == "direction") {
    Json value = Json::parse("[" + text + "]", nullptr, false);
    if (!value.is_discarded()) return value;
  }
  return text;
}

namespace {

/// The value of a style key as JSON has it.
Json style_value(const std::string& key, const std::string& text) {
  Style style;
  // A key of a later kind of strokes is one of a style that has so many.
  while (setting_rank(key) > 0 && stroke_kind_count(style) < kMostStrokeKinds) {
    style.strokes.emplace_back();
  }
  for (const StyleKey& known : style_keys(style)) {
    if (known.name == key) return written_value({.option = known, .group = {}}, text);
  }
  return text;  // "strokes.2.kind"
}

}  // namespace

Json write_style(const Request& options) {
  const std::string named = asked_texts(option_named("style"), options).back();
  std::vector<std::string> changes = given_texts(options, "set");
  for (const auto lights = given_texts(options, "light"); const std::string& light : lights) {
    changes.push_back("tone.light=" + light);
  }
  if (changes.empty()) return named;
  Json style{{"base", named}};
  for (const std::string& change : changes) {
    const auto [name, value] = parted_assignment(change);
    style[name] = style_value(name, value);
  }
  return style;
}

Json write_sections(const Request& options) {
  Json sections = Json::array();
  for (const auto given = given_texts(options, "section"); const std::string& section : given) {
    sections.push_back(Json::object());
    sections.back()["plane"] = section;
  }
  for (const auto given = given_texts(options, "section_view"); const std::string& text : given) {
    sections.push_back({{"plane", text}, {"view", true}});
  }
  const auto numbers = [&](const char* option) {
    const std::vector<std::string> texts = given_texts(options, option);
    return texts.empty() ? Json() : Json::parse("[" + texts.back() + "]");
  };
  if (const Json n = numbers("section_box"); !n.is_null()) {
    sections.push_back(Json::object());
    sections.back()["box"] = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  }
  if (const Json n = numbers("section_around"); !n.is_null()) {
    sections.push_back(Json::object());
    sections.back()["around"] = {{"center", {n[0], n[1], n[2]}}, {"radius", n[3]}};
  }
  const std::vector<std::string> uncut = given_texts(options, "section_exclude");
  for (Json& section : sections) {
    if (uncut.empty()) continue;
    section["exclude"] = uncut == std::vector<std::string>{"none"} ? Json::array() : Json(uncut);
  }
  return sections;
}

}  // namespace detail

namespace {

std::string seen_from(const fs::path& folder, const std::string& file) {
  std::error_code error;
  const fs::path relative = fs::relative(file, folder.empty() ? fs::path(".") : folder, error);
  return error || relative.empty() ? file : relative.string();
}

bool is_style_file(const std::string& style) {
  return style.find('/') != std::string::npos || style.ends_with(".json");
}

/// Of what is asked about reading, what concerns an input; what concerns other files alone would be
/// told as without effect on this one.
Request reading_of(const std::string& input, const std::vector<std::string>& inputs,
                   const Request& options) {
  Request reading;
  for (const auto& row : read_option_rows()) {
    const std::vector<std::string>& texts = given_texts(options, row.name());
    if (texts.empty()) continue;
    const auto concerned = [&](const std::string& file) { return concerns(row.name(), file); };
    if (concerned(input) || std::ranges::none_of(inputs, concerned)) reading[row.name()] = texts;
  }
  return reading;
}

/// The looks that options ask for.
std::vector<LookRequest> looks_of(const Request& options) {
  std::vector<RequestRow<detail::Draft>> rows;
  for (const auto& row : detail::draw_rows()) {
    if (row.name() == "hide" || row.name() == "ghost" || row.name() == "look") rows.push_back(row);
  }
  detail::Draft draft;
  apply(rows, options, Spelling::Options, draft);
  return draft.looks;
}

/// As people read it: what is drawn, the view and the sheet, then how it is drawn.
int place_of(const std::string& key) {
  constexpr std::array kFirst{"burin", "version", "extends", "title", "parts"};
  constexpr std::array kLast{"style",   "lights", "section",    "explode",     "breaks", "details",
                             "threads", "looks",  "parts_list", "title_block", "items"};
  const auto first = std::ranges::find(kFirst, key), last = std::ranges::find(kLast, key);
  if (first != kFirst.end()) return static_cast<int>(first - kFirst.begin());
  constexpr int kOthers = 100;
  return last == kLast.end() ? kOthers : kOthers + 1 + static_cast<int>(last - kLast.begin());
}

std::string text_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  std::ranges::stable_sort(keys, {}, place_of);
  Json sorted;
  for (const std::string& key : keys) sorted[key] = object[key];
  return sorted.dump(2) + "\n";
}

}  // namespace

std::string first_illustration(const std::vector<std::string>& inputs, const DrawRequest& request,
                               const fs::path& folder, const std::vector<ExplodeStep>& steps) {
  IllustrationFile file{.inputs = {}, .request = request};
  for (const std::string& input : inputs) {
    IllustrationInput& one = file.inputs.emplace_back();
    one.file = seen_from(folder, input);
    one.read = reading_of(input, inputs, request.options);
  }
  for (LookRequest& look : file.request.looks) {
    if (is_style_file(look.style)) look.style = seen_from(folder, look.style);
  }
  if (Request& options = file.request.options; options.contains("title_block")) {
    std::string& block = options["title_block"].back();
    if (fs::path(block).has_extension()) block = seen_from(folder, block);
  }
  for (LookRequest& look : looks_of(request.options)) file.request.looks.push_back(std::move(look));
  file.request.explode.steps = steps;
  return text_of(detail::write_object(detail::rows_of_file(), file));
}

namespace {

/// A file that extends another by some keys.
std::string extending(const std::string& base_illustration, const fs::path& folder,
                      const std::vector<std::string>& keys, const IllustrationFile& file) {
  Json json{{"extends", seen_from(folder, base_illustration)}};
  for (const auto& row : detail::rows_of_file()) {
    const bool head = row.name == "burin" || row.name == "version";
    if (!head && std::ranges::find(keys, row.name) == keys.end()) continue;
    const Json value = row.write(file);
    if (!value.is_null()) json[row.name] = value;
  }
  return text_of(json);
}

}  // namespace

std::string exploded_illustration(const std::string& base_illustration, const DrawRequest& request,
                                  const fs::path& folder, const std::vector<ExplodeStep>& steps) {
  IllustrationFile file{.inputs = {}, .request = request};
  file.request.explode.steps = steps;
  return extending(base_illustration, folder, {"explode"}, file);
}

std::string kept_illustration(const std::string& base_illustration, const fs::path& folder,
                              const Illustration& kept) {
  IllustrationFile file;
  file.request.dimensions = kept.dimensions;
  file.request.notes = kept.note_rows;
  if (kept.overall_dimensions) file.request.options["dimensions"] = {"overall"};
  std::vector<std::string> keys;
  if (!kept.dimensions.empty() || kept.overall_dimensions) keys.emplace_back("dimensions");
  if (!kept.note_rows.empty()) keys.emplace_back("notes");
  return extending(base_illustration, folder, keys, file);
}

std::string illustration_schema() {
  Json style_file = Json::parse(style_schema());
  style_file.erase("$schema");
  const Json file = detail::object_schema(detail::rows_of_file());
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Illustration of Burin"},
                    {"type", "object"},
                    {"required", {"burin"}},
                    {"properties", file["properties"]},
                    {"additionalProperties", false},
                    {"$defs", {{"style", std::move(style_file)}}}};
  return schema.dump(2) + "\n";
}

}  // namespace burin
