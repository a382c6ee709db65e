#include "properties.h"

#include "../texture.h"
#include "xml.h"

#include <charconv>
#include <cstdint>

namespace burin {
namespace {

using threemf::attribute;
using threemf::is;

template <class Groups>
auto entry(const Groups& groups, std::string_view group, std::string_view index) ->
    typename Groups::mapped_type::const_pointer {
  const auto found = groups.find(group);
  std::uint32_t i = 0;
  const bool read = std::from_chars(index.data(), index.data() + index.size(), i).ec == std::errc();
  if (found == groups.end() || !read || i >= found->second.size()) return nullptr;
  return &found->second[i];
}

}  // namespace

ThreeMfProperties::ThreeMfProperties(const pugi::xml_node& resources) {
  for (const pugi::xml_node& group : resources) {
    const std::string id(attribute(group, "id"));
    if (is(group, "texture2dgroup")) {
      std::vector<glm::vec2>& points = texture_[id];
      for (const pugi::xml_node& p : group) {
        if (!is(p, "tex2coord")) continue;
        points.emplace_back(texture_coordinate(attribute(p, "u")),
                            texture_coordinate(attribute(p, "v")));
      }
    } else if (is(group, "basematerials")) {
      for (const pugi::xml_node& m : group) {
        if (is(m, "base")) colors_[id].push_back(hex_color(attribute(m, "displaycolor")));
      }
    } else if (is(group, "colorgroup")) {
      for (const pugi::xml_node& c : group) {
        if (is(c, "color")) colors_[id].push_back(hex_color(attribute(c, "color")));
      }
    }
  }
}

glm::vec2 ThreeMfProperties::texture(std::string_view group, std::string_view index) const {
  const glm::vec2* found = entry(texture_, group, index);
  return found ? *found : glm::vec2(kNoTexture);
}

std::optional<Rgba> ThreeMfProperties::color(std::string_view group, std::string_view index) const {
  const std::optional<Rgba>* found = entry(colors_, group, index);
  return found ? *found : std::nullopt;
}

}  // namespace burin
