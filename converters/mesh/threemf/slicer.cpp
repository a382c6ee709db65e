#include "slicer.h"

#include "../xml.h"
#include "package.h"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

namespace burin {
namespace {

using Objects = std::map<std::string, SlicerObject>;

std::string slicer_value(const pugi::xml_node& node, std::string_view key) {
  for (const pugi::xml_node& m : node.children("metadata")) {
    if (m.attribute("key").value() == key) return m.attribute("value").value();
  }
  return {};
}

std::size_t number(const pugi::xml_node& node, const char* name) {
  const std::string_view text = node.attribute(name).value();
  std::size_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// The colours of the filaments in an extruder's order; index 0 is the first.
class Filaments {
 public:
  explicit Filaments(const Package& package) {
    constexpr const char* kSettings = "Metadata/project_settings.config";
    if (!package.has(kSettings)) return;
    const auto json = nlohmann::json::parse(package.read(kSettings), nullptr, false);
    const auto found = json.is_object() ? json.find("filament_colour") : json.end();
    if (!json.is_object() || found == json.end() || !found->is_array()) return;
    for (const auto& color : *found) {
      colors_.push_back(color.is_string() ? hex_color(color.get<std::string>()) : std::nullopt);
    }
  }

  /// Of "extruder" in the settings of an object or part.
  std::optional<Rgba> of(const pugi::xml_node& node) const {
    const std::string text = slicer_value(node, "extruder");
    std::size_t extruder = 0;
    std::from_chars(text.data(), text.data() + text.size(), extruder);
    return extruder >= 1 && extruder <= colors_.size() ? colors_[extruder - 1] : std::nullopt;
  }

 private:
  std::vector<std::optional<Rgba>> colors_;
};

/// Bambu Studio and OrcaSlicer: a part a component.
Objects of_parts(const pugi::xml_node& config, const Filaments& filaments) {
  Objects all;
  for (const pugi::xml_node& o : config.children("object")) {
    SlicerObject& object = all[o.attribute("id").value()];
    object.name = slicer_value(o, "name");
    object.color = filaments.of(o);
    for (const pugi::xml_node& p : o.children("part")) {
      SlicerPart& part = object.parts.emplace_back();
      const std::string_view kind = p.attribute("subtype").value();
      part.id = p.attribute("id").value();
      part.name = slicer_value(p, "name");
      part.solid = kind.empty() || kind == "normal_part";
      part.color = filaments.of(p);
      if (!part.color) part.color = object.color;
    }
  }
  return all;
}

/// PrusaSlicer and its kin: volumes are ranges of an object's triangles.
Objects of_volumes(const pugi::xml_node& config) {
  Objects all;
  for (const pugi::xml_node& o : config.children("object")) {
    SlicerObject& object = all[o.attribute("id").value()];
    object.name = slicer_value(o, "name");
    for (const pugi::xml_node& v : o.children("volume")) {
      SlicerPart& part = object.parts.emplace_back();
      const std::string kind = slicer_value(v, "volume_type");
      part.first = number(v, "firstid");
      part.last = number(v, "lastid");
      part.name = slicer_value(v, "name");
      part.solid = (kind.empty() || kind == "ModelPart") && slicer_value(v, "modifier") != "1";
    }
  }
  return all;
}

}  // namespace

std::map<std::string, SlicerObject> read_slicer_settings(const Package& package) {
  const auto config_of = [&](const char* member, pugi::xml_document& document) {
    if (!package.has(member)) return pugi::xml_node();
    const std::string text = package.read(member);
    return document.load_buffer(text.data(), text.size()) ? document.child("config")
                                                          : pugi::xml_node();
  };
  pugi::xml_document document;
  if (const auto config = config_of("Metadata/model_settings.config", document)) {
    return of_parts(config, Filaments(package));
  }
  for (const char* member : {"Metadata/Slic3r_PE_model.config", "Metadata/Slic3r_model.config"}) {
    if (const auto config = config_of(member, document)) return of_volumes(config);
  }
  return {};
}

}  // namespace burin
