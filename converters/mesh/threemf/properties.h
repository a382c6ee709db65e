#pragma once
/// What the triangles of a 3MF refer to: colours and texture coordinates.

#include "look.h"

#include <glm/vec2.hpp>
#include <pugixml.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Groups of one model part, by their ids: base materials and what is mixed of them, colours,
/// texture coordinates. What
/// refers to no group or to nothing in it has none: neither is worth refusing a model.
class ThreeMfProperties {
 public:
  explicit ThreeMfProperties(const pugi::xml_node& resources);

  bool has_texture() const { return !texture_.empty(); }
  bool has_colors() const { return !colors_.empty(); }
  glm::vec2 texture(std::string_view group, std::string_view index) const;
  std::optional<Rgba> color(std::string_view group, std::string_view index) const;

 private:
  template <class T>
  using Groups = std::map<std::string, std::vector<T>, std::less<>>;

  void mix(const pugi::xml_node& composites);
  void combine(const pugi::xml_node& group);

  Groups<glm::vec2> texture_;
  Groups<std::optional<Rgba>> colors_;
};

}  // namespace burin
