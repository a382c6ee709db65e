#pragma once
// Faces and edges of a healed mesh; internal to the room.

#include <burin/forms/healed/healed_form.h>
#include <burin/mesh/proxy_mesh.h>

#include "refine.h"

#include <vector>

namespace burin::healed {

/// What lies between the faces of the input, before it is refined.
struct Faces {
  HealedMesh mesh;
  std::vector<EdgeRecord> edges;
  /// For each record nonzero where a round surface runs tangent into a plane.
  std::vector<std::uint8_t> tangent;
};

/// `proxy` is what MeshForm makes of the input.
Faces find_faces(const ProxyMesh& proxy, const Facets& facets, const Recognised& round);

/// Connected pieces of round surfaces.
HealedFaces count_faces(const TriMesh& mesh, const Topology& topology, const Facets& facets,
                        const Recognised& round);

/// The proxy of a refined mesh, its edge records as they were before.
ProxyMesh make_proxy(HealedMesh mesh, const Faces& faces, const Facets& facets,
                     const Recognised& round, double tolerance, const RunContext& context);

}  // namespace burin::healed
