#pragma once
/// Numbers that tell shapes apart, wherever they stand.

#include <burin/base/vec.h>
#include <burin/mesh/proxy_mesh.h>

#include <cstdint>

namespace burin {

/// What forms that are instances of one thing share: equal where the shape was read once and placed
/// several times. Shapes that were read twice have two; `ShapeMeasure` compares these.
struct Definition {
  /// Whose address it is does not matter, only whether two are the same.
  const void* shape = nullptr;
  /// What became of it: how it was turned counts for nothing, how it was scaled, stretched, sheared
  /// or mirrored does.
  Mat3 linear{1};

  bool mirrored() const { return glm::determinant(linear) < 0; }
  /// The lengths of all vectors and the angles between them afterwards, which no turn changes.
  Mat3 metric() const { return glm::transpose(linear) * linear; }
  /// Metrics within 2e-9: they come from matrices.
  bool same(const Definition& other) const;
};

/// Integrals and counts of a shape. They do not depend on where it stands, on the order of its
/// faces, nor (of exact forms) on any tessellation.
struct ShapeMeasure {
  /// mm2; mm3, 0 where the shape is open.
  double area = 0, volume = 0;
  /// Second moments of the surface about its own middle along its own axes, ascending, mm4.
  Vec3 moments{0};
  /// Of opposite sign for mirror images, 0 where the shape is its own: det(v, Mv, MMv) of the
  /// direction v from the middle of the body to that of its surface, and the moments M over their
  /// trace. 0 too where both middles are one, or the shape is open: then mirror images are alike.
  double handedness = 0;
  std::int64_t faces = 0, edges = 0;

  /// Whether two shapes are alike within `relative` of their size.
  bool same(const ShapeMeasure& other, double relative = 1e-6) const;
  /// Whether `handedness` tells the shape from its mirror image.
  bool handed() const;
  /// The measure of the same shape made larger, and mirrored.
  ShapeMeasure scaled(double scale, bool mirrored) const;
};

/// Integrals as they come from a mesh or a modeller, about any point: the area and its middle, the
/// matrix of second moments about that middle, the volume (0: open) and its middle.
ShapeMeasure shape_measure(double area, Vec3 area_middle, const Mat3& second_moments, double volume,
                           Vec3 volume_middle);

/// Of triangles. Faces and edges are those of the input where the proxy names them, else smooth
/// regions and none. Cost: 10 ns a triangle.
ShapeMeasure shape_measure(const ProxyMesh& proxy);

}  // namespace burin
