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

/// Entries of a list of the archive, each of `size` bytes with a packed colour at `offset`.
struct ColorList {
  std::size_t size, offset;
};
constexpr ColorList kColors{4, 0};
/// Ambient, diffuse, specular and emissive colour, shininess, transparency. FreeCAD 1.0 writes
/// texts behind the last material.
constexpr ColorList kMaterials{24, 4};

/// The colour that all entries share (behind their count), or empty.
std::string common_color(const std::string& bytes, ColorList list) {
  std::uint32_t count = 0;
  if (bytes.size() < sizeof count) return {};
  std::memcpy(&count, bytes.data(), sizeof count);
  std::string color;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = sizeof count + k * list.size;
    if (i + list.size > bytes.size()) return {};
    std::uint32_t packed = 0;
    std::memcpy(&packed, bytes.data() + i + list.offset, sizeof packed);
    const std::string one = hex(packed);
    if (!color.empty() && one != color) return {};
    color = one;
  }
  return color;
}

}  // namespace

void apply_view(const pugi::xml_node& provider,
                const std::function<std::string(const std::string&)>& list, FcObject& object) {
  std::string shape_color, material_color, faces, materials;
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
    } else if (name == "ShapeAppearance") {  // FreeCAD 1.x, in the stead of the three above
      materials = value.attribute("file").value();
    } else if (name == "OverrideMaterial") {
      object.overrides_color = truth(value);
    }
  }
  if (shape_color.empty()) shape_color = material_color;
  if (!faces.empty()) {
    // Faces of several colours leave the part without one.
    const std::string bytes = list(faces);
    if (bytes.size() >= 8) shape_color = common_color(bytes, kColors);
  }
  if (!materials.empty()) shape_color = common_color(list(materials), kMaterials);
  object.color = shape_color;
}

}  // namespace burin::detail
