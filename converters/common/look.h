#pragma once
/// Colours of files, and what a part has of those of its faces.

#include <burin/base/diagnostics.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// What a part looks like.
struct Appearance {
  /// "#rrggbb", or empty.
  std::string color;
  double opacity = 1;
  bool operator==(const Appearance&) const = default;
};

/// Red, green, blue and opacity, each 0 to 255.
using Rgba = std::array<std::uint8_t, 4>;
Appearance look_of(const Rgba& color);

/// A share of 1, as eight bits; what lies outside is moved to the end.
std::uint8_t channel(double share);

/// Red, green, blue and opacity, each 0 to 1, in light rather than as screens show them: colours
/// mix in it.
using LinearColor = std::array<double, 4>;
/// As screens show it, in sRGB (IEC 61966-2-1), and back.
Rgba displayed(const LinearColor& color);
LinearColor in_light(const Rgba& color);

/// "#rrggbb" or "#rrggbbaa", in any case; nothing where the text is no such colour.
std::optional<Rgba> hex_color(std::string_view text);

/// The look of a part whose faces have colours of their own: theirs where it is one.
class EvenLook {
 public:
  /// Of the next face; absent: it has none.
  void add(const std::optional<Rgba>& color);
  /// Of a face whose corners differ.
  void add_uneven() { several_ = true; }
  /// Whether there was a face with a colour, or one whose corners differ.
  bool any() const { return color_.has_value() || several_; }
  /// Whether faces differ.
  bool several() const { return several_; }
  Appearance look() const;

 private:
  bool any_ = false, several_ = false;
  std::optional<Rgba> color_;
};

/// Says that so many parts have no colour, since their faces have several.
void report_several_colors(std::int64_t parts, Diagnostics& diagnostics);

}  // namespace burin
