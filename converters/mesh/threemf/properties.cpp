#include "properties.h"

#include "../texture.h"
#include "../xml.h"
#include "text.h"

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

/// A layer over what lies below it: as glass of that colour, or covering as much as it is opaque.
Rgba blended(const Rgba& below, const Rgba& layer, bool multiplies) {
  const LinearColor under = in_light(below), over = in_light(layer);
  LinearColor out{};
  if (multiplies) {
    for (std::size_t k = 0; k < out.size(); ++k) out[k] = under[k] * over[k];
    return displayed(out);
  }
  for (std::size_t k = 0; k < 3; ++k) out[k] = over[k] * over[3] + under[k] * (1 - over[3]);
  out[3] = over[3] + under[3] * (1 - over[3]);
  return displayed(out);
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
    if (is(group, "compositematerials")) mix(group);
  }
  for (const pugi::xml_node& group : resources) {
    if (is(group, "multiproperties")) combine(group);
  }
}

/// Materials that are mixed of base materials, by their shares. None where one has no colour.
void ThreeMfProperties::mix(const pugi::xml_node& composites) {
  const std::string_view base = attribute(composites, "matid");
  const std::vector<std::string_view> indices = words(attribute(composites, "matindices"));
  std::vector<std::optional<Rgba>> colors;
  for (const pugi::xml_node& one : composites) {
    if (!is(one, "composite")) continue;
    const std::vector<std::string_view> shares = words(attribute(one, "values"));
    LinearColor sum{};
    double total = 0;
    bool known = true;
    for (std::size_t i = 0; i < indices.size() && i < shares.size(); ++i) {
      double share = 0;
      if (!parse_double(shares[i], share) || !(share > 0)) continue;
      const std::optional<Rgba> material = color(base, indices[i]);
      known = known && material;
      if (!known) break;
      const LinearColor light = in_light(*material);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += share * light[k];
      total += share;
    }
    for (double& channel : sum) channel /= total;
    colors.push_back(known && total > 0 ? std::optional(displayed(sum)) : std::nullopt);
  }
  colors_[std::string(attribute(composites, "id"))] = std::move(colors);
}

/// Several groups of which one is laid over the other.
void ThreeMfProperties::combine(const pugi::xml_node& group) {
  const std::string id(attribute(group, "id"));
  const std::vector<std::string_view> layers = words(attribute(group, "pids"));
  const std::vector<std::string_view> methods = words(attribute(group, "blendmethods"));
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
      if (const auto own = color(layers[i], index)) {
        const bool multiplies = i > 0 && i <= methods.size() && methods[i - 1] == "multiply";
        seen = seen ? blended(*seen, *own, multiplies) : *own;
      }
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
