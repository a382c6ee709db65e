#pragma once
/// Target tone: how light a place of the picture should be.

#include <burin/camera/camera.h>
#include <burin/surface/visible_surfaces.h>
#include <burin/tone/options.h>

#include <functional>

namespace burin {

/// Linear reflectance in [0,1] at a point with its unit normal (turned to the viewer): 1 = white
/// paper, 0 = full ink.
using Tone = std::function<double(Vec3 position, Vec3 normal)>;

namespace tone {

/// Whether something stands between a point of a surface with its normal and a light: in a unit
/// direction, `distance` model mm away (infinite: of a light that is far). From many threads.
using Blocked = std::function<bool(Vec3 position, Vec3 normal, Vec3 towards, double distance)>;

/// By the law of the options, darker at the rim; what is as light as their highlight is white.
/// Costs some ten nanoseconds a place. Shadows, where the options want them, are those of
/// `blocked`, which is asked once a light and place, for wide lights 16 times. Throws UsageError
/// where there is no such law. `shown`: for laws from elsewhere that look at the picture as a
/// whole.
Tone make(const Camera& camera, const ToneOptions& options, const Blocked& blocked = {},
          const VisibleSurfaces& shown = {});

}  // namespace tone
}  // namespace burin
