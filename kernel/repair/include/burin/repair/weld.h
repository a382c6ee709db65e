#pragma once
/// Joining points with equal coordinates.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace burin {

/// Which points are one vertex. Vertices are numbered in the order of their first points.
struct Weld {
  /// For each point its vertex.
  std::vector<std::uint32_t> vertex;
  /// For each vertex the first of its points.
  std::vector<std::uint32_t> first;
};

/// Joins points whose coordinates are exactly equal (0 and -0 are). Linear and parallel: 0.1 s for
/// the three million corners of a binary STL of a million triangles on 2 cores; the result is the
/// same for any number of threads. Throws GeometryError for more than 4,294,967,294 points.
Weld weld(std::span<const std::array<float, 3>> points, const RunContext& context);
Weld weld(std::span<const Vec3> points, const RunContext& context);

}  // namespace burin
