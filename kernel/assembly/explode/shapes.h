#pragma once
// The parts as explosion looks at them; internal to the module.

#include <burin/base/box.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/surface/scene.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace burin::detail {

/// What is the same of equal shapes wherever they stand.
struct Signature {
  double area = 0, volume = 0, spread = 0;

  Signature& operator+=(const Signature& other);
  bool same(const Signature& other) const;
};

/// Parts that were realised; all arrays have one entry a part of the scene.
struct Shapes {
  std::vector<std::shared_ptr<const Surface>> surfaces;
  std::vector<const ProxyMesh*> proxies;
  /// Those that are there, ascending.
  std::vector<std::size_t> parts;
  std::vector<std::string> paths;
  std::vector<std::vector<std::string>> names;
  /// The first part of the thing that each belongs to (burin/assembly/things.h).
  std::vector<std::size_t> things;
  std::vector<Signature> signatures;
  /// The axes of the assembly: rows of the direction in which most of its faces look or round faces
  /// run, the first at a right angle to it, and their cross product.
  Mat3 frame{1};
  /// Boxes in that frame.
  std::vector<Box3> boxes;
  double diagonal = 0;

  /// Model mm: least extent of a part.
  double least_extent(std::size_t part) const;
  Box3 box_along(std::size_t part, const Mat3& rows) const;
};

Shapes make_shapes(const Scene& scene, const std::vector<bool>& drawn, RunContext& context);

/// A direction with how much speaks for it.
struct WeightedAxis {
  Vec3 axis{0};
  double weight = 0;
};

/// Normals of a face with weights: whether they belong to a plane or to a face that is round about
/// an axis.
struct NormalSum {
  double weight = 0;
  Vec3 sum{0};
  Mat3 outer{0};

  void add(Vec3 unit_normal, double w);
  /// The normal of a plane, the axis of a cylinder or a cone; zero where they are neither.
  Vec3 axis() const;
  bool planar() const;
};

/// Directions that differ by less than 2 degrees, or by their sign, made one; heaviest first.
std::vector<WeightedAxis> merged_axes(std::vector<WeightedAxis> axes);

/// Two directions closer than 2 degrees, whatever their signs.
bool same_axis(Vec3 a, Vec3 b);

/// Rows (u, v, axis) of a frame with `axis`, turned as the assembly is.
Mat3 rows_along(Vec3 axis, const Mat3& frame);

/// `rows * p` of rows that Mat3 holds as columns.
inline Vec3 in_rows(const Mat3& rows, Vec3 p) {
  return {glm::dot(rows[0], p), glm::dot(rows[1], p), glm::dot(rows[2], p)};
}

}  // namespace burin::detail
