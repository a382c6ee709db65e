#pragma once
/// Colours of ink and paper.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace burin {

/// Red, green, blue.
using Rgb = std::array<std::uint8_t, 3>;

/// Reads "#rrggbb"; nothing where the text is none.
std::optional<Rgb> rgb_of(std::string_view text);

}  // namespace burin
