#include "color.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace burin::irit {
namespace {

std::optional<std::string> parse_rgb(const std::string& value) {
  std::array<int, 3> rgb{};
  const char* p = value.data();
  const char* end = p + value.size();
  for (std::size_t k = 0; k < 3; ++k) {
    while (p < end && (*p == ',' || is_blank(*p))) ++p;
    const auto [stop, error] = std::from_chars(p, end, rgb[k]);
    if (error != std::errc() || rgb[k] < 0 || rgb[k] > 255) return std::nullopt;
    p = stop;
  }
  return fmt::format("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]);
}

/// The sixteen colours: bits 2, 1, 0 are red, green, blue at two thirds; bit 3 lifts all by one
/// third.
std::optional<std::string> parse_index(const std::string& value) {
  int index = 0;
  const char* end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, index);
  if (error != std::errc() || stop != end || index < 0 || index > 15) return std::nullopt;
  const auto level = [&](int bit) { return (index >> bit & 1) * 0xaa + (index >> 3) * 0x55; };
  return fmt::format("#{:02x}{:02x}{:02x}", level(2), level(1), level(0));
}

}  // namespace

std::optional<std::string> color_of(const IritObject& object) {
  if (const std::string* rgb = object.attribute("RGB")) {
    if (auto color = parse_rgb(*rgb)) return color;
  }
  const std::string* index = object.attribute("COLOR");
  return index == nullptr ? std::nullopt : parse_index(*index);
}

}  // namespace burin::irit
