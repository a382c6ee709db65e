#pragma once
// Unions, differences and intersections of many meshes in one step; for csg/solids alone.

#include <burin/base/run_context.h>

#include "mesh.h"

#include <functional>

namespace burin::csg {

/// How meshes are combined; nodes before their children, node 0 is the whole.
struct Formula {
  enum class Kind : std::uint8_t { Mesh, Union, Difference, Intersection };
  struct Node {
    Kind kind = Kind::Union;
    std::uint32_t mesh = 0;
    std::vector<std::uint32_t> children;
  };
  std::vector<Node> nodes;
};

/// Every facet is cut where it meets facets of other meshes, and of each piece it is asked whether
/// what lies on its two sides belongs to the result: any number of operands costs one cut each, and
/// solids may touch in edges and corners. `share` is called with the part of
/// the work that is done. `through_points` says, by number of a facet's surface, whether that
/// surface is a smooth one through the corners of its facets. Where facets of such a surface cross
/// others at a smaller angle than kGrazing, they do not show where the surfaces cross: the surface
/// is dropped, and its facets are meant as they are.
Mesh combine(Space& space, std::span<const Mesh> meshes, const Formula& formula,
             std::span<const char> through_points, RunContext& context,
             const std::function<void(double)>& share);

/// The cosine of the smallest angle, 10 degrees.
inline constexpr double kGrazing = 0.985;

/// Leaves out corners at which edges only go straight on.
void straighten(Space& space, Mesh& mesh);

/// As triangles in doubles, closed: what rounding makes one point is one. Throws GeometryError
/// where a mesh is not closed.
Solid solid_of(Space& space, const Mesh& mesh);

}  // namespace burin::csg
