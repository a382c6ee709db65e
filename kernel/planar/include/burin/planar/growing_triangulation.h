#pragma once
/// A constrained Delaunay triangulation of the plane that more segments are added to.

#include <burin/base/vec.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace burin {

struct PlanarMesh {
  std::vector<Vec2> points;
  /// Counterclockwise.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// The triangle beyond side `i`, which is opposite corner `i`; -1: none.
  std::vector<std::array<std::int32_t, 3>> beyond;
  /// Whether side `i` is on a segment of the input.
  std::vector<std::array<bool, 3>> constrained;
  /// The triangle with the same corners in the mesh that was taken before; -1: none.
  std::vector<std::int32_t> before;
};

/// Grows by more segments; those that cross are divided where they do. @cite CGAL
class GrowingTriangulation {
 public:
  GrowingTriangulation();
  ~GrowingTriangulation();
  GrowingTriangulation(const GrowingTriangulation&) = delete;
  GrowingTriangulation& operator=(const GrowingTriangulation&) = delete;

  /// Segments by their ends among `points`. Cost: n log n of the first ones; of later ones about
  /// the triangles that they meet.
  void add(std::span<const Vec2> points, std::span<const std::array<std::uint32_t, 2>> segments);
  /// All triangles. Points keep their numbers from one mesh to the next.
  PlanarMesh mesh();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace burin
