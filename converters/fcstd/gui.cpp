#include "gui.h"

#include <fmt/format.h>

#include <cstring>

namespace burin::detail {
namespace {

/// "#rrggbb" of R<<24 | G<<16 | B<<8 | A.
std::string hex(std::uint32_t packed) { return fmt::format("#{:06x}", packed >> 8); }

std::string packed_color(const pugi::xml_node& node, const char* attribute) {
  const double value = number(node, attribute, -1);
  return value >= 0 && value <= 4294967295.0 ? hex(static_cast<std::uint32_t>(value))
                                             : std::string();
}

/// The colour that all entries share (a count and packed colours), or empty.
std::string common_color(const std::string& bytes) {
  if (bytes.size() < 8) return {};
  std::string color;
  for (std::size_t i = 4; i + 4 <= bytes.size(); i += 4) {
    std::uint32_t packed = 0;
    std::memcpy(&packed, bytes.data() + i, sizeof packed);
    const std::string one = hex(packed);
    if (!color.empty() && one != color) return {};
    color = one;
  }
  return color;
}

}  // namespace

void apply_view(const pugi::xml_node& provider,
                const std::function<std::string(const std::string&)>& list, FcObject& object) {
  std::string shape_color, material_color, faces;
  for (const pugi::xml_node& p : provider.child("Properties").children("Property")) {
    const std::string_view name = p.attribute("name").value();
    const pugi::xml_node value = first_element(p);
    if (name == "Visibility") {
      object.visible = truth(value);
    } else if (name == "ShapeColor") {
      shape_color = packed_color(value, "value");
    } else if (name == "ShapeMaterial") {
      material_color = packed_color(value, "diffuseColor");
    } else if (name == "DiffuseColor") {
      faces = value.attribute("file").value();
    } else if (name == "OverrideMaterial") {
      object.overrides_color = truth(value);
    }
  }
  if (shape_color.empty()) shape_color = material_color;
  if (!faces.empty()) {
    // Faces of several colours leave the part without one.
    const std::string bytes = list(faces);
    if (bytes.size() >= 8) shape_color = common_color(bytes);
  }
  object.color = shape_color;
}

}  // namespace burin::detail
