#pragma once
// Which parts hide others; internal to the module.

#include <burin/camera/camera.h>

#include "occluders.h"

#include <cstddef>
#include <span>
#include <vector>

namespace burin::detail {

/// The solid parts, ascending, without which a camera sees most of some others: the one that stands
/// before most of what is hidden first, until half of what faces the viewer is seen. Cost: 400
/// rays.
std::vector<std::size_t> parts_before(std::span<const std::size_t> shown,
                                      const Occluders& occluders, const Camera& camera);

}  // namespace burin::detail
