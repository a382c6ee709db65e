#pragma once
// Contours inside smooth regions.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>

#include "facing.h"

#include <cstdint>
#include <vector>

namespace burin {

struct Contours {
  std::vector<Curve3> curves;
  /// Closed curves left out as noise.
  std::int64_t noise = 0;
};

/// The zero set of g over the triangles of a part, one segment a triangle, chained; ends lie on
/// creases and boundaries and are bit for bit the points where `Facing::crossing` cuts those.
Contours trace_contours(const Facing& facing, std::int32_t part, const RunContext& context);

/// One entry a segment of a contour whose front side lies to its left: nonzero where its back side
/// is in front of it in the picture. The sign of the tangent's part along (to_viewer x normal),
/// freed of changes that last for less than kCuspLength.
std::vector<std::uint8_t> folded_under(const std::vector<Vec3>& points,
                                       const std::vector<Vec3>& normals, bool closed,
                                       const Camera& camera);

}  // namespace burin
