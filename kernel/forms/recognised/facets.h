#pragma once
// Flat facets of a mesh and which of them meet; internal to the module.

#include <burin/base/run_context.h>
#include <burin/mesh/topology.h>
#include <burin/mesh/tri_mesh.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace burin::recognised {

inline std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
constexpr double kDegree = std::numbers::pi / 180, kTurn = 2 * std::numbers::pi;
/// Of the first two steps of a run, or the sides of a circle: how unequal they may be.
constexpr double kEqual = 0.02;
/// Facets of which one bends no more than so many times as much as the next are those of one curve;
/// circles beyond are stretches of a spline.
constexpr double kOtherCircle = 1.5;

/// In [0, pi], of vectors of any length.
inline double angle_between(Vec3 a, Vec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

struct FacetLink {
  std::int32_t facet = -1;
  /// Length of the common edges in mm.
  double length = 0;
};

/// Triangles that lie in one plane and hang together: normal . x = offset.
struct Facet {
  Vec3 normal{0};
  double offset = 0;
  double area = 0;
  Vec3 center{0};
  std::vector<std::uint32_t> triangles;
  /// Each once, ascending.
  std::vector<std::uint32_t> vertices;
  std::vector<FacetLink> links;
};

struct Facets {
  std::vector<Facet> list;
  /// For each triangle its facet.
  std::vector<std::int32_t> of;
  /// How far, in mm, coordinates may be off: a few units of the last digit that meshes are written
  /// with.
  double noise = 0;
};

/// How far, in mm, the coordinates of a mesh may be off.
double mesh_noise(const TriMesh& mesh);

/// A facet ends where the plane does, and where a label (one a triangle, or none at all) changes.
Facets find_facets(const TriMesh& mesh, const Topology& topology, const RunContext& context,
                   std::span<const std::int32_t> label = {});

}  // namespace burin::recognised
