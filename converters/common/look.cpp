#include "look.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

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

Appearance look_of(const std::string& color) {
  const std::optional<Rgba> known = hex_color(color);
  return known ? look_of(*known) : Appearance{color};
}

std::string color_text(const Appearance& look, double of_part) {
  const std::uint8_t opacity = channel(look.opacity);
  if (look.color.empty() || opacity == 255 || look.opacity == of_part) return look.color;
  return look.color + fmt::format("{:02x}", opacity);
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

void FaceLooks::add(const std::optional<Rgba>& color, std::size_t faces) {
  if (faces == 0 || too_many()) return;
  const auto [at, is_new] = numbers_.try_emplace(color, static_cast<std::int32_t>(looks_.size()));
  if (is_new) looks_.push_back(color);
  if (too_many()) return of_face_.clear();
  if (numbers_.size() > 1) {
    of_face_.resize(count_, 0);
    of_face_.resize(count_ + faces, at->second);
  }
  count_ += faces;
}

Appearance FaceLooks::look() const {
  return looks_.size() == 1 && looks_[0] ? look_of(*looks_[0]) : Appearance{};
}

std::shared_ptr<const FaceColors> FaceLooks::colors() const {
  if (numbers_.size() < 2 || too_many()) return nullptr;
  FaceColors out;
  std::map<std::string, std::int32_t> places;
  std::vector<std::int32_t> place;  // of each look
  for (const std::optional<Rgba>& look : looks_) {
    if (!look) {
      place.push_back(-1);
      continue;
    }
    const auto [at, is_new] = places.try_emplace(color_text(look_of(*look)),
                                                 static_cast<std::int32_t>(out.colors.size()));
    if (is_new) out.colors.push_back(at->first);
    place.push_back(at->second);
  }
  out.of_face.reserve(of_face_.size());
  for (const std::int32_t look : of_face_) {
    out.of_face.push_back(place[static_cast<std::size_t>(look)]);
  }
  return std::make_shared<const FaceColors>(std::move(out));
}

std::optional<Rgba> color_of_corners(std::span<const std::optional<Rgba>> corners) {
  std::optional<Rgba> best;
  std::ptrdiff_t most = 0;
  for (const std::optional<Rgba>& one : corners) {
    const std::ptrdiff_t count = std::ranges::count(corners, one);
    if (count > most) best = one;
    most = std::max(most, count);
  }
  return best;
}

FaceLooks looks_by_vertices(const PolygonSoup& soup, std::span<const std::optional<Rgba>> colors) {
  FaceLooks looks;
  std::vector<std::optional<Rgba>> corners;
  for (std::size_t f = 0; f + 1 < soup.offsets.size() && !looks.too_many(); ++f) {
    corners.clear();
    for (std::size_t c = soup.offsets[f]; c < soup.offsets[f + 1]; ++c) {
      corners.push_back(soup.indices[c] < colors.size() ? colors[soup.indices[c]] : std::nullopt);
    }
    looks.add(color_of_corners(corners));
  }
  return looks;
}

void report_many_colors(std::int64_t parts, Diagnostics& diagnostics) {
  if (parts == 0) return;
  diagnostics.add(Severity::Info, "mesh.many_colors", parts,
                  "parts have faces of more than 64 colours; they are drawn as if they had none");
}

}  // namespace burin
