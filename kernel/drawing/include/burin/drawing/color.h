#pragma once
/// Colours of ink and paper.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// Red, green, blue.
using Rgb = std::array<std::uint8_t, 3>;

/// Reads "#rrggbb"; nothing where the text is none.
std::optional<Rgb> rgb_of(std::string_view text);

/// Names that stand for colours: "orange", "red" and so on.
std::vector<std::string> color_names();

/// "#rrggbb" for a name of a colour, in letters of any case; any other text as it is.
std::string without_name(std::string_view text);

/// Whether it is black, white or between them.
bool is_grey(const Rgb& color);

/// "#rrggbb".
std::string to_text(const Rgb& color);

/// What is wrong with the name of a spot ink, as in "takes a name of ..."; empty: nothing.
std::string fault_of_ink(std::string_view name);

/// The colour with `share` of its lightness and of its chroma as the eye sees them, its hue kept.
/// `share`: 0 (black) to 1. @cite Ottosson2020
Rgb with_lightness(const Rgb& color, double share);

/// The colour, lighter where lines of a dark `ink` could not be seen on it: mixed with white until
/// their contrast is 3 to 1. @cite WCAG21
Rgb readable(const Rgb& color, const Rgb& ink);

/// The colour that is seen where one of `opacity` (0 to 1) lies over another.
Rgb over(const Rgb& color, double opacity, const Rgb& below);

}  // namespace burin
