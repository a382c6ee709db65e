#pragma once
/// Convex outlines of points.

#include <burin/base/vec.h>

#include <vector>

namespace burin {

/// The corners of the convex hull, anticlockwise from the leftmost, of equal ones the lowest; none
/// of them in line with its neighbours. Of points in one line both ends, of one point that. Cost:
/// that of sorting. @cite Andrew1979
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

}  // namespace burin
