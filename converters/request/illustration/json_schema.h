#pragma once
// Pieces of JSON Schema; internal to the module.

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace burin::detail {

nlohmann::ordered_json text(const char* what);
nlohmann::ordered_json flag(const char* what);
/// Three numbers.
nlohmann::ordered_json vector_of(const char* what);
nlohmann::ordered_json list_of(nlohmann::ordered_json items);
/// One, or a list of them.
nlohmann::ordered_json one_or_list_of(const nlohmann::ordered_json& item);
/// For "oneOf": objects that have one of these keys.
nlohmann::ordered_json either(const std::vector<std::string>& keys);
nlohmann::ordered_json object_of(nlohmann::ordered_json properties);
/// What names parts.
nlohmann::ordered_json selector();
/// What an option takes; free text may be written as numbers and lists too.
nlohmann::ordered_json value_of_option(const std::string& option);

}  // namespace burin::detail
