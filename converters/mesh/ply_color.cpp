#include "ply_color.h"

#include <array>
#include <string_view>

namespace burin {
namespace {

int channel_named(std::string_view name) {
  constexpr std::string_view kDiffuse = "diffuse_";
  if (name.starts_with(kDiffuse)) name.remove_prefix(kDiffuse.size());
  constexpr std::array<std::string_view, 4> kNames{"red", "green", "blue", "alpha"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (name == kNames[i]) return static_cast<int>(i);
  }
  return -1;
}

/// The value that a full channel has.
double full(PlyType type) {
  if (type == PlyType::Float || type == PlyType::Double) return 1;
  return type == PlyType::UInt16 ? 65535 : 255;
}

}  // namespace

PlyColors::PlyColors(const PlyElement& element) {
  for (const PlyProperty& p : element.properties) {
    const int channel = p.is_list ? -1 : channel_named(p.name);
    channel_of_.push_back(channel);
    unit_.push_back(1 / full(p.type));
    if (channel >= 0 && channel < 3) has_[static_cast<std::size_t>(channel)] = true;
  }
}

void PlyColors::take(std::size_t property, double value) {
  color_[static_cast<std::size_t>(channel_of_[property])] = channel(value * unit_[property]);
}

}  // namespace burin
