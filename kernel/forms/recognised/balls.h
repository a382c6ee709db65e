#pragma once
// Facets whose corners lie on a sphere; internal to the module.

#include "facets.h"

#include <vector>

namespace burin::recognised {

struct Ball {
  Vec3 center{0};
  /// Negative where the facets look to the middle.
  double radius = 0;
  /// Largest distance of a facet from the sphere.
  double sagitta = 0;
  std::vector<std::int32_t> facets;
};

/// Spheres by vertices with facets at small angles all around them, and the facets that hang
/// together there, also those that a cut has made smaller. Any polyhedron of many faces whose
/// corners lie on a sphere is one: whether its facets are arranged as on a globe is another
/// question.
std::vector<Ball> find_balls(const TriMesh& mesh, const Facets& facets, const RunContext& context);

}  // namespace burin::recognised
