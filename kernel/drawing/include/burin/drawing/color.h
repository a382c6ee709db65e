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

/// Names that stand for colours: "orange", "red" and so on, then those that CSS has beside them.
std::vector<std::string> color_names();

/// What messages say of them: "orange, red ... or another name of CSS, such as steelblue".
std::string said_color_names();

/// "#rrggbb" for a name of a colour, in letters of any case; any other text as it is.
std::string without_name(std::string_view text);

/// "; a colour has no alpha ..." for "#rrggbbaa"; empty for other texts.
std::string hint_of_alpha(std::string_view text);

/// Whether it is black, white or between them.
bool is_grey(const Rgb& color);

/// "#rrggbb".
std::string to_text(const Rgb& color);

/// What is wrong with the name of a spot ink, as in "takes a name of ..."; empty: nothing.
std::string fault_of_ink(std::string_view name);

/// The colour with `share` of its lightness and of its chroma as the eye sees them, its hue kept.
/// `share`: 0 (black) to 1. @cite Ottosson2020
Rgb with_lightness(const Rgb& color, double share);

/// How well two colours are told apart, from 1, not at all, to 21, black and white. @cite WCAG21
double contrast(const Rgb& a, const Rgb& b);

/// The contrast that areas have to the lines on them, at least: in full light, and in the darkest
/// tone, which is to stay a shade.
constexpr double kLeastContrast = 3, kLeastShadeContrast = 2.1;

/// The tones of one colour: in full light, and the lightness of the darkest, as a share of that.
struct Tones {
  Rgb light{};
  double darkest = 1;
};

/// Tones of the colour on which lines of `ink` are seen, with these contrasts: where they are dark
/// the darkest one is lighter, up to a share of 0.86, so that tones are told apart, and the
/// colour is mixed with white. Where they are light, so that no colour is light enough beside them,
/// it is darker. Beside a grey ink dark tones have less contrast, so that colours stay colours.
Tones readable(const Tones& tones, const Rgb& ink);

/// The same for a colour that must stay as it is: the share of lightness of its darkest tone.
double readable_darkest(const Tones& tones, const Rgb& ink);

/// The colour that is seen where one of `opacity` (0 to 1) lies over another.
Rgb over(const Rgb& color, double opacity, const Rgb& below);

}  // namespace burin
