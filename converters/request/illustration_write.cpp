#include <burin/converters/illustration.h>

#include "illustration_keys.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// A text as JSON has the values of an option.
Json value_of(const RequestOption& option, const std::string& text) {
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

/// The value of a style key as JSON has it.
Json style_value(const std::string& key, const std::string& text) {
  Style style;
  // A key of a later kind of strokes is one of a style that has so many.
  while (setting_rank(key) > 0 && stroke_kind_count(style) < kMostStrokeKinds) {
    style.strokes.emplace_back();
  }
  for (const StyleKey& known : style_keys(style)) {
    if (known.name == key) return value_of({.option = known, .group = {}}, text);
  }
  return text;  // "strokes.2.kind"
}

/// To six digits: no picture shows more, and an author reads them.
double rounded(double value) { return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr); }

Json step_json(const Explode::Step& step) {
  Json along = Json::array();
  for (int k = 0; k < 3; ++k) along.push_back(rounded(step.along[k]) + 0.0);
  return {{"move", step.move}, {"along", along}, {"by", rounded(step.by)}, {"trail", step.trail}};
}

std::string seen_from(const fs::path& folder, const std::string& file) {
  std::error_code error;
  const fs::path relative = fs::relative(file, folder.empty() ? fs::path(".") : folder, error);
  return error || relative.empty() ? file : relative.string();
}

Json explode_json(const DrawRequest& request, const std::vector<Explode::Step>& steps) {
  Json explode;
  explode["steps"] = Json::array();
  for (const Explode::Step& step : steps) explode["steps"].push_back(step_json(step));
  const std::vector<std::string>& factor = given_texts(request.options, "explode_factor");
  if (!factor.empty()) {
    explode["factor"] = value_of(detail::option_named("explode_factor"), factor.back());
  }
  return explode;
}

/// What options about sections ask, as an illustration has it.
std::vector<Json> sections_json(const DrawRequest& request) {
  std::vector<Json> sections;
  for (const std::string& section : given_texts(request.options, "section")) {
    sections.push_back(Json::object());
    sections.back()["plane"] = section;
  }
  const auto numbers = [&](const char* option) {
    const std::vector<std::string>& texts = given_texts(request.options, option);
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
  const std::vector<std::string>& uncut = given_texts(request.options, "section_exclude");
  for (Json& section : sections) {
    if (uncut.empty()) continue;
    section["exclude"] = uncut == std::vector<std::string>{"none"} ? Json::array() : Json(uncut);
  }
  return sections;
}

Json schema_of(const std::string& option) {
  return Json::parse(value_schema(detail::option_named(option).option));
}

/// What free text may be written as: numbers and lists too.
Json loosened(Json value) {
  if (value.value("type", "") != "string") return value;
  value["type"] = {"string", "number", "array"};
  return value;
}

Json object_of(Json properties) {
  return {
      {"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json vector_of(const char* what) {
  return {{"description", what},
          {"type", "array"},
          {"items", {{"type", "number"}}},
          {"minItems", 3},
          {"maxItems", 3}};
}

Json text(const char* what) { return {{"description", what}, {"type", "string"}}; }
Json flag(const char* what) { return {{"description", what}, {"type", "boolean"}}; }

Json matrix_schema() {
  const Json row = {
      {"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 4}, {"maxItems", 4}};
  return {{"description",
           "in place of the others: rows of an affine matrix that acts on columns; it may stretch, "
           "shear and mirror"},
          {"type", "array"},
          {"items", row},
          {"minItems", 3},
          {"maxItems", 4}};
}

Json input_schema() {
  Json members;
  members["file"] = text("a model file, seen from the folder of this one");
  members["function"] = text("instead of a file: the text of an implicit function");
  members["name"] = text("what the part is called, or the assembly that its parts make");
  members["place"] = object_of(
      {{"translate", vector_of("model mm")},
       {"rotate", vector_of("degrees about x, then y, then z; before it is moved")},
       {"scale",
        {{"description",
          "one factor, or three along the part's own x, y and z, before it is turned; "
          "negative ones mirror"},
         {"anyOf",
          {{{"type", "number"}, {"minimum", 1e-9}, {"maximum", 1e9}}, vector_of("x, y, z")}}}},
       {"matrix", matrix_schema()}});
  for (const auto& row : read_option_rows()) {
    Json value = loosened(schema_of(row.name()));
    if (row.about.many) value["type"] = {"string", "array", "object"};
    members[row.name()] = std::move(value);
  }
  return object_of(std::move(members));
}

Json select_schema() {
  return text(
      "a part or an assembly: its name, its path, @color=#rrggbb, @index=N or "
      "@file=NAME; * and ? are wild");
}

Json item_schema() {
  Json item = object_of({{"name", text("what the list calls it")}, {"select", select_schema()}});
  item["minProperties"] = 1;
  return item;
}

Json look_schema(const Json& style) {
  const Json select = select_schema();
  Json look = object_of(
      {{"select", {{"anyOf", {select, list_of(select)}}}},
       {"style", style},
       {"drawn", flag("false: as if the part were not there")},
       {"hatched", flag("false: without strokes")},
       {"transparent", flag("true: of glass; it hides itself alone, and keeps its strokes")},
       {"listed", flag("false: no item of a parts list, and without a callout")}});
  look["required"] = {"select"};
  return look;
}

Json section_schema() {
  const Json section_text = text(
      "x, y, z with a sign for the side that goes, or X,Y,Z; =OFFSET in mm; quarter; x,y for what "
      "lies beyond both; y=2,x=10,y=6 for steps");
  Json plane = object_of(
      {{"normal", vector_of("towards what is taken away")}, {"offset", {{"type", "number"}}}});
  plane["required"] = {"normal"};
  const Json one = {{"anyOf", {text("x, y, z with a sign, or X,Y,Z; =OFFSET in mm"), plane}}};
  Json planes = list_of(one), steps = list_of(one), box = list_of(vector_of("a corner, model mm"));
  planes["description"] = "what lies beyond all of them goes";
  planes["minItems"] = 1;
  planes["maxItems"] = 64;
  steps["description"] = "a cut, where it ends, the next cut, and so on";
  steps["minItems"] = 3;
  steps["maxItems"] = 64;
  box["description"] = "what is inside goes";
  box["minItems"] = 2;
  box["maxItems"] = 2;
  Json around = object_of({{"center", vector_of("model mm")},
                           {"radius", {{"type", "number"}, {"exclusiveMinimum", 0}}}});
  around["description"] = "what lies before this place and around it goes";
  around["required"] = {"center", "radius"};
  const Json selector = text("a selector of parts that stay whole");
  Json exclude = {{"anyOf", {selector, list_of(selector)}}};
  exclude["description"] = "without it: those that drawings leave whole by custom";
  Json section = object_of({{"plane", {{"anyOf", {section_text, plane}}}},
                            {"planes", planes},
                            {"steps", steps},
                            {"box", box},
                            {"around", around},
                            {"exclude", exclude}});
  section["oneOf"] = Json::array();
  for (const char* kind : {"plane", "planes", "steps", "box", "around"}) {
    Json required;
    required["required"] = Json::array({kind});
    section["oneOf"].push_back(std::move(required));
  }
  return {{"anyOf", {section_text, section}}};
}

Json explode_schema() {
  const Json way = text("auto, none, x, y or z, one with a sign, or X,Y,Z");
  const Json ways = {{"anyOf", {way, vector_of("one way alone")}}};
  const Json selector = text("what moves: a part or an assembly, as in looks");
  Json step = object_of({{"move", {{"anyOf", {selector, list_of(selector)}}}},
                         {"along", vector_of("the way, in model axes")},
                         {"by",
                          {{"description", "model mm"},
                           {"type", "number"},
                           {"exclusiveMinimum", 0},
                           {"maximum", 1e12}}},
                         {"trail", flag("false: no trail line is drawn")}});
  step["required"] = {"move", "along", "by"};
  Json steps = list_of(step);
  steps["minItems"] = 1;
  const Json whole = object_of({{"steps", steps},
                                {"along", ways},
                                {"base", text("the part that stays where steps are found")},
                                {"fit",
                                 {{"description", "model mm that parts may lie in each other"},
                                  {"type", "number"},
                                  {"minimum", 0},
                                  {"maximum", 1e6}}},
                                {"factor", {{"type", "number"}, {"minimum", 0}, {"maximum", 10}}}});
  return {{"anyOf", {ways, whole}}};
}

Json detail_schema() {
  const Json short_form = text("a part or an assembly, or X,Y,Z,R in mm; =A:B behind it");
  const Json selector = text("what is drawn larger: a part or an assembly, as in looks");
  const Json whole = object_of(
      {{"select", {{"anyOf", {selector, list_of(selector)}}}},
       {"at", vector_of("instead: the point in its middle, model mm")},
       {"radius", {{"description", "model mm"}, {"type", "number"}, {"exclusiveMinimum", 0}}},
       {"scale", loosened(schema_of("scale"))},
       {"letter", text("its letter (default: the next of A, B, C ...)")}});
  return {{"anyOf", {short_form, whole}}};
}

Json light_schema() {
  const Json strength = {{"type", "number"}, {"minimum", 0}, {"maximum", 10}};
  return object_of({{"ambient", strength},
                    {"from", vector_of("to the light: right, up, towards the viewer")},
                    {"at", vector_of("where the light is, in model mm")},
                    {"strength", strength}});
}

}  // namespace

std::string first_illustration(const std::vector<std::string>& inputs, const DrawRequest& request,
                               const fs::path& folder, const std::vector<Explode::Step>& steps) {
  Json json{{"burin", "illustration"}, {"version", 1}, {"parts", Json::array()}};
  Request reading;
  for (const auto& row : read_option_rows()) {
    const auto& texts = given_texts(request.options, row.name());
    if (!texts.empty()) reading[row.name()] = texts;
  }
  for (const std::string& input : inputs) {
    Json part{{"file", seen_from(folder, input)}};
    for (const auto& entry : reading) {
      const auto& [name, texts] = entry;
      const auto concerned = [&](const std::string& file) { return concerns(entry.first, file); };
      // What concerns other files alone would be told as without effect on this one.
      if (!concerned(input) && std::ranges::any_of(inputs, concerned)) continue;
      const RequestOption& option = detail::option_named(name);
      part[name] = option.many ? Json(texts) : value_of(option, texts.back());
    }
    json["parts"].push_back(std::move(part));
  }
  for (const detail::IllustrationKey& key : detail::illustration_keys()) {
    const RequestOption& option = detail::option_named(key.option);
    const std::vector<std::string> texts = asked_texts(option, request.options);
    if (texts.empty()) continue;
    if (!request.has(key.option)) {
      // What holds without being asked for is written to be edited, where it has an effect.
      const bool apart = !steps.empty();  // the view is then found
      if (key.option == "projection" || (key.option == "view" && apart)) continue;
    }
    const std::size_t dot = key.path.find('.');
    Json& to = dot == std::string::npos ? json[key.path]
                                        : json[key.path.substr(0, dot)][key.path.substr(dot + 1)];
    to = value_of(option, texts.back());
  }
  const std::vector<std::string> styles =
      asked_texts(detail::option_named("style"), request.options);
  std::vector<std::string> changes = given_texts(request.options, "set");
  for (const std::string& light : given_texts(request.options, "light")) {
    changes.push_back("tone.light=" + light);
  }
  if (changes.empty()) {
    json["style"] = styles.back();
  } else {
    json["style"]["base"] = styles.back();
    for (const std::string& change : changes) {
      const auto [name, value] = parted_assignment(change);
      json["style"][name] = style_value(name, value);
    }
  }
  for (Json& section : sections_json(request)) json["section"].push_back(std::move(section));
  if (!steps.empty()) json["explode"] = explode_json(request, steps);
  for (const std::string& detail : given_texts(request.options, "detail")) {
    json["details"].push_back(detail);
  }
  json["looks"] = Json::array();
  for (const std::string& selector : given_texts(request.options, "hide")) {
    json["looks"].push_back({{"select", selector}, {"drawn", false}});
  }
  for (const std::string& selector : given_texts(request.options, "ghost")) {
    json["looks"].push_back({{"select", selector}, {"hatched", false}, {"transparent", true}});
  }
  for (const std::string& look : given_texts(request.options, "look")) {
    const std::size_t equals = look.rfind('=');
    json["looks"].push_back(
        {{"select", look.substr(0, equals)}, {"style", look.substr(equals + 1)}});
  }
  if (std::ranges::count(given_texts(request.options, "parts_list"), "sheet") > 0) {
    json["parts_list"] = "sheet";
  }
  for (const auto& [number, item] : request.items) {
    json["items"][std::to_string(number)] = item.name;
  }
  return json.dump(2) + "\n";
}

std::string exploded_illustration(const std::string& house, const DrawRequest& request,
                                  const fs::path& folder, const std::vector<Explode::Step>& steps) {
  const Json json{{"burin", "illustration"},
                  {"version", 1},
                  {"extends", seen_from(folder, house)},
                  {"explode", explode_json(request, steps)}};
  return json.dump(2) + "\n";
}

std::string illustration_schema() {
  Json named = text("a built-in style, or a style file seen from the folder of this one");
  const Json style = {{"anyOf", {named, {{"$ref", "#/$defs/style"}}}}};
  Json members;
  members["burin"] = {{"const", "illustration"}};
  members["version"] = {{"const", 1}};
  members["$schema"] = {{"type", "string"}};
  members["extends"] = text("an illustration file whose keys hold where this one has none");
  members["title"] = text("what the drawing is called (default: by its parts)");
  members["parts"] = list_of(input_schema());
  members["style"] = style;
  members["looks"] = list_of(look_schema(style));
  members["lights"] = list_of(light_schema());
  members["explode"] = explode_schema();
  members["details"] = list_of(detail_schema());
  members["items"] = {
      {"description", "numbers of items and their names; kept from drawing to drawing"},
      {"type", "object"},
      {"propertyNames", {{"pattern", "^[1-9][0-9]{0,4}$"}}},
      {"additionalProperties",
       {{"anyOf", {{{"type", "string"}, {"minLength", 1}}, item_schema()}}}}};
  members["parts_list"] = {{"description", "a parts list on the sheet"}, {"const", "sheet"}};
  members["section"] = {{"anyOf", {section_schema(), list_of(section_schema())}}};
  for (const detail::IllustrationKey& key : detail::illustration_keys()) {
    const std::size_t dot = key.path.find('.');
    Json value = loosened(schema_of(key.option));
    if (dot == std::string::npos) {
      members[key.path] = std::move(value);
      continue;
    }
    Json& group = members[key.path.substr(0, dot)];
    if (group.is_null()) group = object_of(Json::object());
    group["properties"][key.path.substr(dot + 1)] = std::move(value);
  }
  members["paper"] = {{"anyOf", {members["paper"], loosened(schema_of("paper"))}}};
  Json style_file = Json::parse(style_schema());
  style_file.erase("$schema");
  const Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Illustration of Burin"},
                    {"type", "object"},
                    {"required", {"burin"}},
                    {"properties", std::move(members)},
                    {"additionalProperties", false},
                    {"$defs", {{"style", std::move(style_file)}}}};
  return schema.dump(2) + "\n";
}

}  // namespace burin
