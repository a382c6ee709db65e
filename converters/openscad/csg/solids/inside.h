#pragma once
// Whether a place lies within a mesh; for csg/solids alone.

#include "mesh.h"

#include <array>

namespace burin::csg {

/// A place within a facet's plane, away from all edges.
class Sample {
 public:
  /// Within a triangle of the plane. The rays go along the plane's main axis.
  Sample(Space& space, Id plane, const std::array<Id, 3>& triangle);

  Vec3 at{0};
  /// How far off the doubles are; what is nearer to anything than this is decided exactly.
  double error = 0;
  Id plane = 0;
  int axis = 0;
  const Exact& exact();

 private:
  Space& space_;
  std::array<Id, 3> triangle_;
  bool thin_ = false, solved_ = false;
  Exact exact_;
};

/// Counts what rays from samples hit of a mesh.
class Inside {
 public:
  Inside(Space& space, const Mesh& mesh) : space_(space), mesh_(mesh) {}

  /// Whether the ray from the sample along its axis passes an odd number of facets, those in the
  /// sample's own plane left out.
  bool odd(Sample& sample);

 private:
  struct Grid {
    bool made = false;
    std::size_t n = 1;
    Vec2 low{0}, step{1};
    std::vector<std::uint32_t> begin, facets;
  };

  bool hits(const Facet& facet, Sample& sample);
  bool hits_exactly(const Facet& facet, Sample& sample);
  void make(Grid& grid, int axis) const;

  Space& space_;
  const Mesh& mesh_;
  std::array<Grid, 3> grids_;
};

}  // namespace burin::csg
