#pragma once
/// Where a shape stands, as numbers.

#include <burin/base/box.h>
#include <burin/mesh/tri_mesh.h>

namespace burin {

/// Numbers that change with any move or turn of a shape but those that leave it as it is.
struct Pose {
  /// Of its surface; of its box where it has none.
  Vec3 middle{0};
  /// Second moments of the surface about the middle, along the model's axes, over the area: mm2.
  Mat3 spread{0};
  Box3 box;
  /// Model mm that the middle may be off, as curved faces were measured by triangles.
  double error = 0;
};

/// The pose of triangles that may lie `tolerance` mm off their surface. Cost: 10 ns a triangle.
Pose pose_of(const TriMesh& mesh, double tolerance);

}  // namespace burin
