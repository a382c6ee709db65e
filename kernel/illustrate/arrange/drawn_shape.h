#pragma once
/// The size of what is drawn, as the view shows it; internal to the module.

#include <burin/arrange/illustration.h>
#include <burin/base/vec.h>
#include <burin/surface/scene.h>

namespace burin::detail {

/// Width and height of the one view of a sheet with its shadow, model mm, once parts are where they
/// are drawn; 0 where there are several views, whose shape is known when they are arranged.
Vec2 drawn_shape(const Scene& scene, const Illustration& illustration);

}  // namespace burin::detail
