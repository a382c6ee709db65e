#pragma once
/// The steps of build_proxy that walk on the OpenMesh (the others: build_steps.h).

#include "ring_mesh.h"

#include <vector>

namespace burin {

/// Fills edge_kind, from the normals of the triangles. `crease_angle` in degrees.
void classify_edges(const RingMesh& rings, ProxyMesh& proxy, const std::vector<Vec3>& normals,
                    double crease_angle, const RunContext& context);

/// Fills wedge_normal.
void find_wedge_normals(const RingMesh& rings, ProxyMesh& proxy,
                        const std::vector<Vec3>& face_normals, const RunContext& context);

}  // namespace burin
