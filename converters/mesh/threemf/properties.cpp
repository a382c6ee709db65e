#include "properties.h"

#include "../texture.h"
#include "../xml.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <utility>

namespace burin {
namespace {

using xml::attribute;
using xml::is;

template <class Groups>
auto entry(const Groups& groups, std::string_view group, std::string_view index) ->
    typename Groups::mapped_type::const_pointer {
  const auto found = groups.find(group);
  std::uint32_t i = 0;
  const bool read = std::from_chars(index.data(), index.data() + index.size(), i).ec == std::errc();
  if (found == groups.end() || !read || i >= found->second.size()) return nullptr;
  return &found->second[i];
}

/// The words of a text that blanks part.
std::vector<std::string_view> words(std::string_view text) {
  std::vector<std::string_view> out;
  constexpr std::string_view kBlanks = " \t\r\n";
  for (std::size_t at = text.find_first_not_of(kBlanks); at != text.npos;) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    out.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kBlanks, end);
  }
  return out;
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
  for (const pugi::xml_node& group : resources) {
    if (is(group, "multiproperties")) combine(group);
  }
}

/// Several groups of which one is laid over the other: the last that has a colour is seen.
void ThreeMfProperties::combine(const pugi::xml_node& group) {
  const std::string id(attribute(group, "id"));
  const std::vector<std::string_view> layers = words(attribute(group, "pids"));
  const auto is_texture = [&](std::string_view layer) { return texture_.contains(layer); };
  const bool textured = std::ranges::any_of(layers, is_texture);
  std::vector<std::optional<Rgba>> colors;
  std::vector<glm::vec2> points;
  for (const pugi::xml_node& multi : group) {
    if (!is(multi, "multi")) continue;
    const std::vector<std::string_view> indices = words(attribute(multi, "pindices"));
    std::optional<Rgba>& seen = colors.emplace_back();
    glm::vec2& point = points.emplace_back(kNoTexture);
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const std::string_view index = i < indices.size() ? indices[i] : "0";
      if (const auto own = color(layers[i], index)) seen = own;
      if (is_texture(layers[i])) point = texture(layers[i], index);
    }
  }
  colors_[id] = std::move(colors);
  if (textured) texture_[id] = std::move(points);
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
