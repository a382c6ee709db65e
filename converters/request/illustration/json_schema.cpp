#include "json_schema.h"

#include "keys.h"

#include <utility>

namespace burin::detail {

using Json = nlohmann::ordered_json;

Json text(const char* what) {
  return {{"description", what}, {"type", "string"}, {"minLength", 1}};
}
Json flag(const char* what) { return {{"description", what}, {"type", "boolean"}}; }

Json vector_of(const char* what) {
  return {{"description", what},
          {"type", "array"},
          {"items", {{"type", "number"}}},
          {"minItems", 3},
          {"maxItems", 3}};
}

Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json one_or_list_of(const Json& item) { return {{"anyOf", {item, list_of(item)}}}; }

Json either(const std::vector<std::string>& keys) {
  Json one = Json::array();
  for (const std::string& key : keys) {
    Json with;
    with["required"] = Json::array({key});
    one.push_back(std::move(with));
  }
  return one;
}

Json object_of(Json properties) {
  return {
      {"type", "object"}, {"additionalProperties", false}, {"properties", std::move(properties)}};
}

Json selector() {
  return text(
      "a part or an assembly: its name, its path, @color=#rrggbb, @index=N or "
      "@file=NAME; * and ? are wild");
}

Json value_of_option(const std::string& option) {
  Json value = Json::parse(value_schema(option_named(option).option));
  if (value.value("type", "") == "string") value["type"] = {"string", "number", "array"};
  return value;
}

}  // namespace burin::detail
