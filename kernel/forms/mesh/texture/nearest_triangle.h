#pragma once
/// The triangle of a mesh that is nearest to a point; internal to the module.

#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <memory>

namespace burin::detail {

/// A tree of boxes over the triangles of a mesh. Safe from many threads once it is made.
class NearestTriangle {
 public:
  /// Takes finite positions and triangles that have an area, at least one. The mesh must outlive
  /// it. Cost: 0.5 s a million triangles.
  explicit NearestTriangle(const TriMesh& mesh);
  ~NearestTriangle();
  NearestTriangle(const NearestTriangle&) = delete;
  NearestTriangle& operator=(const NearestTriangle&) = delete;

  struct Found {
    std::uint32_t triangle = 0;
    Vec3 position{0};
  };
  /// The place of the mesh that is nearest to `p`. Cost: O(log n).
  Found at(Vec3 p) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace burin::detail
