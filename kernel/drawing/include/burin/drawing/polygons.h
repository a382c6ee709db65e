#pragma once
/// The rings of an area as polygons, each with its holes, as geometry libraries take them.

#include <burin/base/vec.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin {

/// A ring and the ones that are cut out of it, by their numbers.
struct RingPolygon {
  std::size_t shell = 0;
  std::vector<std::size_t> holes{};
};

/// What lies within an odd number of rings, which may touch but not cross each other; a ring within
/// a hole is a polygon of its own. In the order of the shells. Cost: a look at the sides of each
/// ring for each that lies within its bounds.
std::vector<RingPolygon> polygons_of(std::span<const std::vector<Vec2>> rings);

}  // namespace burin
