#pragma once
// Faces and edges of a recognised mesh; internal to the module.

#include <burin/forms/recognised/recognised_form.h>
#include <burin/mesh/proxy_mesh.h>

#include "refine.h"

#include <vector>

namespace burin::recognised {

/// What lies between the faces of the input, before it is refined.
struct Faces {
  FacetMesh mesh;
  std::vector<EdgeRecord> edges;
  /// For each record nonzero where a round surface runs tangent into a plane.
  std::vector<std::uint8_t> tangent;
};

/// `proxy` is what MeshForm makes of the input.
Faces find_faces(const ProxyMesh& proxy, const Facets& facets, const Recognised& round);

/// Connected pieces of round surfaces.
RecognisedFaces count_faces(const TriMesh& mesh, const Topology& topology, const Facets& facets,
                            const Recognised& round);

/// Whether surfaces with these normals go over into one another as a fillet does: one continues the
/// run of facets of the other, whose largest angle is `turn`.
bool go_over(double turn, Vec3 one, Vec3 other);

}  // namespace burin::recognised
