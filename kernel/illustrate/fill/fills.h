#pragma once
// The flat colours of areas; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/drawing/color.h>
#include <burin/drawing/drawing.h>
#include <burin/surface/scene.h>

#include "../part_styles.h"

#include <string>
#include <vector>

namespace burin::detail {

/// The colours of parts. Those without one of their own have one of a palette that people who see
/// fewer colours can tell apart, by what they are instances of: it stays in all views of a scene.
/// @cite Tol2021
class Fills {
 public:
  /// Both must outlive it.
  Fills(const Scene& scene, const PartStyles& part_styles);

  /// "#rrggbb" in full light and, of an ink, all of it; empty where the part has none.
  std::string color(std::size_t part) const;
  /// The same of an area: of faces that are coloured otherwise than their part. It is not painted
  /// yet, or a square of the legend.
  std::string color(const Area& area) const;
  /// Gives an area the colour of its part and tone, and its opacity: in a part that is looked
  /// through that of a face of glass is its own. Lines are seen on the tones of colours of the
  /// input (`readable`).
  void paint(Area& area) const;
  /// What `paint` makes of a colour of a part in full light, but for inks and opacity.
  std::string lit(std::size_t part, const std::string& color) const;
  /// The colour of a part's lines.
  Rgb ink_of(std::size_t part) const;
  /// All colours that a part and its faces may have in full light, before inks, as `FaceColors` has
  /// them; its own first.
  std::vector<std::string> colors(std::size_t part) const;

 private:
  Tones tones_of(std::size_t part, const Rgb& color) const;

  const Scene& scene_;
  const PartStyles& part_styles_;
  std::vector<std::string> own_;
  Rgb paper_;
};

/// Gives an area, before it is painted, a colour of `FaceColors`: its fill, and its opacity where
/// that is of glass.
void set_face_color(const std::string& color, Area& area);

/// Whether faces of a part are of glass that is drawn as solid, since the part as a whole is.
bool has_solid_glass(const Part& part);

/// Whether the area of a tone holds the darker ones, which are painted over it.
bool nests(const FillOptions& fill);

/// Whether any part that is drawn has a flat colour.
bool paints(const PartStyles& part_styles);

/// Gives the areas of a drawing their colours and inks, and brings them into the order of painting:
/// what can be looked through over what is behind it. Tells of named colours that hide the lines,
/// and of an ink that has several colours, or stands for faces that have colours of their own.
void paint_areas(const Scene& scene, const PartStyles& part_styles, Drawing& drawing);

/// Gives the shade of parts without a colour the colour of shadows.
void shade_areas(const Style& style, std::vector<Area>& areas);

/// Mixes the colour of an area, or none, with that of the paper, so that nothing is seen through
/// it.
void settle_on(const Rgb& paper, Area& area);

/// Divides the squares of the legend into the tones of their parts, where these differ by more than
/// light: in the share of an ink, or in hatching.
void divide_squares(const Scene& scene, const Style& style, const IllustrateOptions& options,
                    Drawing& drawing);

/// Lays a shadow below all areas, in its colour. It is not seen through parts that are opaque, even
/// if their colour is not, or they have none: that is mixed with the paper.
void lay_shadow(Area shadow, const Style& style, const PartStyles& part_styles,
                std::vector<Area>& areas);

}  // namespace burin::detail
