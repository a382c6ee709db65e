#pragma once
/// What a user chooses of light and shade.

#include <burin/base/vec.h>
#include <burin/options/declared.h>

#include <string>
#include <vector>

namespace burin::tone {

/// A light of a scene, in the place of `ToneOptions::light`, `ambient` and `diffuse`.
struct Light {
  enum class Kind {
    Ambient,  // from everywhere
    From,     // `place`: from the model to the light in view space, as ToneOptions::light
    At,       // `place`: where the light is, in model mm
  };
  Kind kind = Kind::From;
  Vec3 place{0, 0, 1};
  /// What it adds to the reflectance of a surface that faces it.
  double strength = 1;

  bool operator==(const Light&) const = default;
};

struct ToneOptions {
  /// The name of a row of `catalogue()`.
  std::string law = "lambert";
  /// From the model to the light in view space: x right, y up, z to the viewer; any length but
  /// zero.
  Vec3 light{-0.5, 0.65, 0.6};
  /// Reflectance in full shade and gain of the lit part.
  double ambient = 0.35;
  double diffuse = 0.82;
  /// Gain of the light that comes back from behind: shade is lightest where it faces away from the
  /// light in the picture.
  double reflected = 0;
  /// The law "phong": gain of the mirrored light, and how narrow it is (its exponent).
  double specular = 0.5;
  double shininess = 20;
  /// The law "silhouette": how fast the dark falls off from the silhouettes (an exponent).
  double decay = 3;
  /// How much of a light is missing where something stands between it and the surface, and the
  /// degrees about its direction that the light itself is wide: shadows of the laws "lambert" and
  /// "phong".
  double shadow = 0;
  double shadow_width = 0;
  /// What is this light, or lighter, is white paper; tones below are stretched to meet it.
  double highlight = 0.7;
  /// Darkness added where the surface turns away from the viewer, as engravers round a form; 0 =
  /// none. Paper that is white without it stays white.
  double rim = 0.05;
  /// What ink stands for. Light: wide lines where it is lit, as a scraper has them on black.
  /// @cite Elber1998
  enum class Ink { Shade, Light };
  Ink ink = Ink::Shade;
  /// Of the whole picture. The ink of which half of it has more: where the light gives less than
  /// the first or more than the second, one exponent of all ink from 0.5 to 1.5 brings it there.
  double median_min = 0;
  double median_max = 1;
  /// Ink by which planes differ at least from the faces that they meet at an edge, as far as 0.08
  /// of theirs brings them.
  double contrast = 0;
  /// Ink by which a slanted plane is darker where it is nearest than where it is farthest.
  double gradient = 0;
  /// Those of the scene; empty: `light` with `ambient` and `diffuse`. No option row: styles have no
  /// lights.
  std::vector<Light> lights = {};
  /// Of the options that laws from elsewhere declare.
  DeclaredValues declared{};

  bool operator==(const ToneOptions&) const = default;
};
/// Names without a group: "light", "ambient" ...
const std::vector<OptionRow<ToneOptions>>& tone_option_rows();

}  // namespace burin::tone
