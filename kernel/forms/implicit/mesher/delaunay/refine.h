#pragma once
// Delaunay refinement of a surface, without a word of the library that does it.

#include <burin/base/box.h>
#include <burin/base/vec.h>
#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// What refinement asks of the surface. Asked from one thread; whatever is thrown passes through
/// and ends the refinement.
class RefineField {
 public:
  RefineField() = default;
  RefineField(const RefineField&) = delete;
  RefineField& operator=(const RefineField&) = delete;
  virtual ~RefineField() = default;

  virtual bool inside(Vec3 p) = 0;
  /// A point of the surface between a and b, of which exactly one is inside.
  virtual Vec3 crossing(Vec3 a, Vec3 b) = 0;
  /// The radius in model mm that the ball around p through a triangle's corners may have.
  virtual double radius(Vec3 p) = 0;
  /// The length in model mm of edges along curves at p.
  virtual double edge(Vec3 p) = 0;
};

struct RefineInput {
  /// Holds the surface; everything outside is outside.
  Box3 box;
  /// Points of the surface, of every component of it.
  std::vector<Vec3> seeds;
  /// Curves that triangles' edges follow: they meet at their ends alone. First point equal to the
  /// last one: closed.
  std::vector<std::vector<Vec3>> curves;
  /// Single points that are to be vertices.
  std::vector<Vec3> corners;
  /// Model mm that a triangle's centre may lie off the surface.
  double distance = 1;
  /// Edges along curves are not made shorter than this, even where curves come near one another.
  double least_edge = 0;
  std::size_t most_vertices = 0;
};

struct RefinedMesh {
  std::vector<Vec3> positions;
  /// ccw seen from outside.
  std::vector<Triangle> triangles;
  /// For each vertex: 2 on the surface, 1 on a curve, 0 on an end of a curve or a corner.
  std::vector<std::uint8_t> dimension;
  /// Whether `most_vertices` ended it.
  bool full = false;
  /// Whether every edge has two triangles, and the triangles around each vertex are one fan.
  bool manifold = false;
};

/// Sequential and the same on every run. Throws std::runtime_error where points are not finite and
/// where curves meet elsewhere than at their ends. Cost: 30 to 60 us per triangle. @cite
/// Boissonnat2005
/// @cite Cheng2007
RefinedMesh refine_surface(const RefineInput& input, RefineField& field);

}  // namespace burin
