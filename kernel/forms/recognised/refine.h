#pragma once
// Triangles cut finer until they lie on the round surfaces that they stand for; internal to the
// module.

#include <burin/mesh/proxy_mesh.h>

#include "recognise.h"

#include <cstdint>
#include <vector>

namespace burin::recognised {

/// What an edge of the mesh between two faces is.
struct EdgeRecord {
  std::int32_t source = -1;
  bool sharp = false;
};

/// Triangles with what they belong to. Half-edges as in Topology.
struct FacetMesh {
  TriMesh mesh;
  /// For each triangle: its patch or -1, its facet of the input, its face.
  std::vector<std::int32_t> patch, facet, face;
  /// The face that the input says, or none at all: the input tells none apart.
  std::vector<std::int32_t> source;
  /// For each half-edge: its record or -1, and at its origin the unit normal that MeshForm would
  /// give (where there is no patch).
  std::vector<std::int32_t> edge;
  std::vector<Vec3> normal;

  void add(Triangle t, std::size_t like, const std::int32_t (&edges)[3], const Vec3 (&normals)[3],
           const FacetMesh& from);
};

/// Moves corners where round surfaces meet others onto both, then splits edges until their middles
/// are within `tolerance` mm of the surfaces and neighbouring normals within 12 degrees.
void refine(FacetMesh& mesh, const Recognised& round, const Facets& facets, double tolerance,
            const RunContext& context);

}  // namespace burin::recognised
