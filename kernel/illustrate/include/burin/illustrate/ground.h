#pragma once
/// The invisible ground under a scene, on which its shadow lies: the plane square to z through the
/// lowest point of what is drawn.

#include <burin/base/placement.h>
#include <burin/base/vec.h>
#include <burin/camera/camera.h>
#include <burin/illustrate/illustrate.h>

#include <span>

namespace burin {

/// Whether light and viewer (unit vectors from the model to them) are so far above the ground that
/// a shadow on it is drawn.
bool casts_ground_shadow(Vec3 to_light, Vec3 to_viewer);

/// Takes points to where the light through them meets the ground at the height `ground`.
/// `to_light.z` > 0.
Placement onto_ground(Vec3 to_light, double ground);

/// The style of a view in a grid of views: seen from straight above it has no shadow on the ground,
/// beside which it would not stand in line with the others.
Style style_in_grid(Style style, Vec3 to_viewer);

/// `drawn_bounds` with the shadow on the ground, where the style has one: what a sheet has to hold
/// in that view. Scene and styles must outlive it. Throws UsageError where the view has no
/// direction.
Camera::ExtentFn extent_with_shadow(const Scene& scene, const Style& style,
                                    std::span<const PartStyle> part_styles,
                                    const ViewOptions& view);

/// The lines of annotations of parts that a view may draw, and boxes about their letters, model mm.
std::vector<std::vector<Vec3>> annotation_lines(const Scene& scene,
                                                std::span<const PartStyle> part_styles,
                                                const PmiOptions& options, const ViewOptions& view);

}  // namespace burin
