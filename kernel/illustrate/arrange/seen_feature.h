#pragma once
// Whether a part shows a face to the viewer; internal to the module.

#include <burin/arrange/dimension_row.h>
#include <burin/measure/feature.h>
#include <burin/surface/surface.h>

namespace burin::detail {

/// Whether something of a face or an edge is seen in a direction, as far as its own part hides it:
/// by a ray at each of 48 places of it at the most. Cost: 5 ns a triangle and ray.
bool shows_feature(const Surface& surface, const Feature& feature, FeatureRow::Kind kind,
                   Vec3 to_viewer);

/// Whether a place is seen in a direction, as far as a part hides it.
bool shows_place(const Surface& surface, Vec3 place, Vec3 to_viewer);

}  // namespace burin::detail
