#include "gui.h"

#include "binary.h"
#include "look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <utility>

namespace burin::detail {
namespace {

/// "#rrggbb" of R<<24 | G<<16 | B<<8 | A.
std::string hex_color(std::uint32_t packed) { return fmt::format("#{:06x}", packed >> 8); }

double opacity_of(double transparency) {
  return std::isfinite(transparency) ? 1 - std::clamp(transparency, 0.0, 1.0) : 1;
}

std::string packed_color(const pugi::xml_node& node, const char* attribute) {
  const double value = number(node, attribute, -1);
  return value >= 0 && value <= 4294967295.0 ? hex_color(static_cast<std::uint32_t>(value))
                                             : std::string();
}

/// The look that all entries of a list of the archive share, else one a face, and the opacity of
/// what covers most.
class CommonLook {
 public:
  void add(std::uint32_t packed, double transparency) {
    looks_.push_back({hex_color(packed), opacity_of(transparency)});
    opacity_ = std::max(opacity_, looks_.back().opacity);
  }
  bool empty() const { return looks_.empty(); }
  FcLook look() const {
    if (empty()) return {};
    const auto as_first = [&](const Appearance& one) { return one == looks_.front(); };
    if (std::ranges::all_of(looks_, as_first)) return {looks_.front().color, opacity_};
    std::vector<std::string> texts;
    for (const Appearance& one : looks_) texts.push_back(color_text(one, opacity_));
    const bool one_color = std::ranges::all_of(
        looks_, [&](const Appearance& one) { return one.color == looks_.front().color; });
    return {one_color ? looks_.front().color : std::string(), opacity_,
            std::make_shared<const std::vector<std::string>>(std::move(texts))};
  }

 private:
  std::vector<Appearance> looks_;
  double opacity_ = 0;
};

std::uint32_t word(const std::string& bytes, std::size_t offset) {
  return load<std::uint32_t>(bytes.data() + offset, std::endian::little);
}

/// How many entries of `size` bytes there are behind their count; none where the list is cut.
std::size_t entries(const std::string& bytes, std::size_t size) {
  if (bytes.size() < sizeof(std::uint32_t)) return 0;
  const std::size_t count = word(bytes, 0);
  return count <= (bytes.size() - sizeof(std::uint32_t)) / size ? count : 0;
}

/// Colours of faces, their alpha being transparency.
CommonLook look_of_colors(const std::string& bytes) {
  CommonLook common;
  for (std::size_t k = 0; k < entries(bytes, 4); ++k) {
    const auto packed = word(bytes, 4 + 4 * k);
    common.add(packed, (packed & 0xff) / 255.0);
  }
  return common;
}

/// Ambient, diffuse, specular and emissive colour, shininess, transparency. FreeCAD 1.0 writes
/// texts behind the last material.
CommonLook look_of_materials(const std::string& bytes) {
  constexpr std::size_t kSize = 24;
  CommonLook common;
  for (std::size_t k = 0; k < entries(bytes, kSize); ++k) {
    const std::size_t from = 4 + kSize * k;
    common.add(word(bytes, from + 4), load<float>(bytes.data() + from + 20, std::endian::little));
  }
  return common;
}

}  // namespace

void apply_view(const pugi::xml_node& provider,
                const std::function<std::string(const std::string&)>& list, FcObject& object) {
  FcLook shape, material;
  std::string faces, materials;
  for (const pugi::xml_node& p : provider.child("Properties").children("Property")) {
    const std::string_view name = p.attribute("name").value();
    const pugi::xml_node value = first_element(p);
    if (name == "Visibility") {
      object.visible = truth(value);
    } else if (name == "ShapeColor") {
      shape.color = packed_color(value, "value");
    } else if (name == "Transparency") {  // per cent
      shape.opacity = opacity_of(number(value, "value", 0) / 100);
    } else if (name == "ShapeMaterial") {
      material = {packed_color(value, "diffuseColor"),
                  opacity_of(number(value, "transparency", 0))};
    } else if (name == "DiffuseColor") {
      faces = value.attribute("file").value();
    } else if (name == "ShapeAppearance") {  // FreeCAD 1.x, in the stead of the three above
      materials = value.attribute("file").value();
    } else if (name == "OverrideMaterial") {
      object.overrides_look = truth(value);
    }
  }
  object.look = shape.color.empty() ? material : shape;
  if (!faces.empty()) {
    CommonLook common = look_of_colors(list(faces));
    if (!common.empty()) object.look = common.look();
  }
  if (!materials.empty()) object.look = look_of_materials(list(materials)).look();
}

}  // namespace burin::detail
