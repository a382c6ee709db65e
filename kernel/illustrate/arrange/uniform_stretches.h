#pragma once
// Stretches of a model over which its cross-section stays the same; internal to the module.

#include <burin/base/vec.h>
#include <burin/surface/surface.h>

#include <memory>
#include <vector>

namespace burin::detail {

/// Parts as they are measured, one each; null where one is not drawn.
struct MeasuredParts {
  std::vector<std::shared_ptr<const Surface>> surfaces;
  /// Model mm.
  double tolerance = 0;
};

/// Model mm along an axis.
struct UniformStretch {
  double low = 0, high = 0;
  /// Of what runs along it: the larger side of its box across the axis.
  double width = 0;
};

/// The stretches along `axis` (unit) in which no face of the parts turns towards the axis and no
/// edge ends or leaves its direction, ascending; none where there is nothing. Cost: a look at each
/// triangle.
std::vector<UniformStretch> uniform_stretches(const MeasuredParts& parts, const Vec3& axis);

}  // namespace burin::detail
