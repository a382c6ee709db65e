#pragma once
/// Colours of files, and what a part has of those of its faces.

#include <burin/base/diagnostics.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/face_colors.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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
class FaceLooks {
 public:
  /// Of the next faces, which look alike; absent: they have none.
  void add(const std::optional<Rgba>& color, std::size_t faces = 1);
  /// Whether there was a face with a colour.
  bool any() const { return numbers_.size() > numbers_.count(std::nullopt); }
  /// Whether faces have so many colours that they are no areas: as of a photograph, or of values.
  bool too_many() const { return numbers_.size() > kMost; }
  /// Of all faces, or empty where they differ.
  Appearance look() const;
  /// By face, in their order, with the opacity of glass; absent where they look alike, and where
  /// there are too many.
  std::shared_ptr<const FaceColors> colors() const;

 private:
  static constexpr std::size_t kMost = 64;

  std::map<std::optional<Rgba>, std::int32_t> numbers_;
  std::vector<std::optional<Rgba>> looks_;
  /// Of each face its place in `looks_`; kept where there are several.
  std::vector<std::int32_t> of_face_;
  std::size_t count_ = 0;
};

/// What a part looks like by a colour of `FaceColors`, such as that of most of its faces.
Appearance look_of(const std::string& color);
/// The same the other way: glass has its opacity in the text, but for the opacity `of_part`, which
/// its part has.
std::string color_text(const Appearance& look, double of_part = 1);

/// The colour that most corners of a face have, the first of them that is so.
std::optional<Rgba> color_of_corners(std::span<const std::optional<Rgba>> corners);

/// The look of polygons whose vertices have colours, one a position; fewer: none has any.
FaceLooks looks_by_vertices(const PolygonSoup& soup, std::span<const std::optional<Rgba>> colors);

/// Says that so many parts have no colour, since their faces have too many.
void report_many_colors(std::int64_t parts, Diagnostics& diagnostics);

}  // namespace burin
