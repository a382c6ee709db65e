#pragma once
// Elements and attributes by their names without the prefix of a namespace; internal to the module.

#include <pugixml.hpp>

#include <cstring>
#include <string_view>

namespace burin::xml {

inline std::string_view local_name(const char* name) {
  const char* colon = std::strrchr(name, ':');
  return colon == nullptr ? name : colon + 1;
}

inline bool is(const pugi::xml_node& node, std::string_view name) {
  return local_name(node.name()) == name;
}

inline pugi::xml_node child(const pugi::xml_node& node, std::string_view name) {
  return node.find_child([&](const pugi::xml_node& n) { return is(n, name); });
}

inline std::string_view attribute(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& a : node.attributes()) {
    if (local_name(a.name()) == name) return a.value();
  }
  return {};
}

}  // namespace burin::xml
