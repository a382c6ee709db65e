#pragma once
// Whether points lie on a mesh; internal to the module.

#include <burin/base/box.h>
#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// The triangles of a mesh in a tree of boxes. An occluder would do, but takes milliseconds to
/// make, and there may be ten thousand parts. The mesh must outlive it. Cost: 0.3 us a triangle and
/// level of the tree to make, 0.2 us a question.
class NearSurface {
 public:
  explicit NearSurface(const TriMesh& mesh);

  /// Whether any triangle lies within `reach` mm of a point.
  bool within(Vec3 point, double reach) const;

 private:
  struct Node {
    Box3 box;
    /// Of a leaf: its triangles; else `count` is 0, its first child comes next and `first` is the
    /// other.
    std::uint32_t first = 0, count = 0;
  };
  std::uint32_t make(std::uint32_t first, std::uint32_t last);

  const TriMesh& mesh_;
  std::vector<std::uint32_t> triangles_;
  std::vector<Vec3> middles_;
  std::vector<Node> nodes_;
};

}  // namespace burin
