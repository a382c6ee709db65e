#pragma once
/// Bezier patches in homogeneous coordinates.

#include <burin/forms/charted/nurbs.h>

#include <vector>

namespace burin::irit {

/// Points (w x, w y, w z, w), index = i * (degree_v + 1) + j.
struct HomogeneousPatch {
  int degree_u = 0, degree_v = 0;
  std::vector<glm::dvec4> points;
};

/// Appends the patch, split until all its weights are positive; false where that does not come
/// about (a point of the surface itself lies at infinity) or a coordinate is
/// absurdly large.
bool append_positive(const HomogeneousPatch& patch, std::vector<NurbsData>& patches);

}  // namespace burin::irit
