#include "look.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace burin {
namespace {

double displayed(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double in_light(std::uint8_t channel) {
  const double shown = channel / 255.0;
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

}  // namespace

Rgba displayed(const LinearColor& color) {
  return {channel(displayed(color[0])), channel(displayed(color[1])), channel(displayed(color[2])),
          channel(color[3])};
}

LinearColor in_light(const Rgba& color) {
  return {in_light(color[0]), in_light(color[1]), in_light(color[2]), color[3] / 255.0};
}

Appearance look_of(const Rgba& color) {
  return {fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]), color[3] / 255.0};
}

std::uint8_t channel(double share) {
  return static_cast<std::uint8_t>(std::lround(255 * (share > 0 ? std::min(share, 1.0) : 0.0)));
}

std::optional<Rgba> hex_color(std::string_view text) {
  if (!text.starts_with('#') || (text.size() != 7 && text.size() != 9)) return std::nullopt;
  Rgba color{0, 0, 0, 255};
  for (std::size_t i = 0; 2 * i + 2 < text.size(); ++i) {
    const char* at = text.data() + 1 + 2 * i;
    const auto [end, error] = std::from_chars(at, at + 2, color[i], 16);
    if (error != std::errc() || end != at + 2) return std::nullopt;
  }
  return color;
}

void EvenLook::add(const std::optional<Rgba>& color) {
  if (any_ && color != color_) several_ = true;
  any_ = true;
  color_ = color;
}

Appearance EvenLook::look() const { return several_ || !color_ ? Appearance{} : look_of(*color_); }

void report_several_colors(std::int64_t parts, Diagnostics& diagnostics) {
  if (parts == 0) return;
  diagnostics.add(Severity::Info, "mesh.several_colors", parts,
                  "parts have faces of several colours; a part has one colour, so these have none");
}

}  // namespace burin
