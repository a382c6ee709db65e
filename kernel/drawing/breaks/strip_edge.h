#pragma once
// Lines and rings with the points of the jagged edge of a strip; internal to the module.

#include <burin/drawing/clip.h>

#include <vector>

namespace burin::detail {

/// The same path with points where the edge of the strip has some, so that the edge is straight
/// over each of its segments.
Path refined(const Path& path, const Strip& strip);
std::vector<Vec2> refined_ring(std::vector<Vec2> ring, const Strip& strip);

}  // namespace burin::detail
