#pragma once
/// Boxes of a shape along any axes, from its curves and surfaces.

#include <burin/base/box.h>

#include "model_parts.h"

namespace burin {

/// Samples of edges and of the insides of faces, from which the search for the farthest point of
/// each direction starts. Faces made of straight lines (planes, cylinders, cones, extrusions) end
/// in every direction at their edges. Samples of the others are taken inside their wires.
class ShapeBounds {
 public:
  /// Cost: 2 us per edge, 20 us per face that is bent both ways.
  explicit ShapeBounds(const ModelParts& parts);
  ShapeBounds() = default;

  /// The box of axes * p. Cost: 10 ns per sample, 50 us where a curved edge or face is the
  /// farthest.
  Box3 box(const ModelParts& parts, const Mat3& axes) const;

  struct CurveSamples {
    std::int32_t edge = -1;
    std::size_t first = 0, count = 0;
    /// How far the curve may lie outside its samples.
    double slack = 0;
  };
  struct FaceSamples {
    std::int32_t face = -1;
    std::size_t first = 0, count = 0;
    Vec2 cell{0};
    double slack = 0;
  };

 private:
  void sample_edge(const ModelParts& parts, std::int32_t edge);
  std::vector<Vec3> points_;  // of vertices, then of curves
  std::vector<CurveSamples> curves_;
  std::vector<FaceSamples> faces_;
  std::vector<Vec3> face_points_;
  std::vector<Vec2> face_uv_;
};

}  // namespace burin
