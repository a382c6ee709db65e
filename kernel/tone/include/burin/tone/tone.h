#pragma once
/// Target tone: how light a place of the picture should be.

#include <burin/camera/camera.h>
#include <burin/surface/surface.h>

#include <functional>

namespace burin {

/// Linear reflectance in [0,1] at a point with its unit normal (turned to the viewer): 1 = white
/// paper, 0 = full ink.
using Tone = std::function<double(Vec3 position, Vec3 normal)>;

namespace tone {

/// The defaults are those of `Style`.
struct LambertOptions {
  /// From the model to the light in view space: x right, y up, z to the viewer; any length but
  /// zero.
  Vec3 light{-0.5, 0.65, 0.6};
  /// Reflectance in full shade and gain of the lit part.
  double ambient = 0.35;
  double diffuse = 0.82;
  /// What is this light, or lighter, is white paper; tones below are stretched to meet it.
  double highlight = 0.7;
  /// Darkness added where the surface turns away from the viewer, as engravers round a form; 0 =
  /// none.
  double rim = 0.05;
};

/// A distant light, ambient light, white highlights.
Tone lambert(const Camera& camera, const LambertOptions& options);

}  // namespace tone
}  // namespace burin
