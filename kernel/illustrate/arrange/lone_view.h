#pragma once
// A view that has a sheet for itself, and what views of a sheet have in common; internal to the
// module.

#include <burin/annotate/dimensions.h>
#include <burin/arrange/illustration.h>
#include <burin/camera/camera.h>
#include <burin/camera/sheet.h>
#include <burin/illustrate/sheet.h>
#include <burin/surface/scene.h>

#include "sheet_dimensions.h"

namespace burin::detail {

/// Dimensions stand at places that depend on the scale, and the scale on the room for them: tries
/// until one has room for the other. The room only grows, so that this ends.
inline constexpr int kMostRounds = 8;

/// What is drawn in a view, with its shadow on the ground where there is one.
Camera::ExtentFn extent_of(const Scene& scene, const Illustration& illustration,
                           const ViewOptions& view);
/// What is drawn, with the ends of what is measured of all of it: corners of a box about it, which
/// an oblique view may show farther out.
Camera::ExtentFn with_measured(Camera::ExtentFn drawn, const ViewDimensions& measured);

Margin sum(const Margin& a, const Margin& b);

/// The view that is asked for, as dimensions see it.
SheetView lone_view(const Scene& scene, const Illustration& illustration);
/// A sheet with that view alone.
SheetOfViews plan_lone_view(Scene& scene, const Illustration& illustration);

}  // namespace burin::detail
