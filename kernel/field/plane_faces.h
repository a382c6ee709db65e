#pragma once
/// The plane faces of an exact form, which get one direction each.

#include <burin/base/run_context.h>
#include <burin/field/field.h>

#include "flat_patches.h"

#include <vector>

namespace burin::field {

/// Plane faces that a smooth edge joins are one patch. Directions follow the policy: those of
/// `flat_cross`, or of the style where it has none.
FlatPatches find_plane_faces(const Surface& surface, const std::vector<FaceKind>& kinds,
                             const SmoothedOptions& options, const RunContext& context);

/// Exchanges the families of flat parts that only creases bound so that they differ from their
/// neighbours over creases as much as they can; parallel ones of one outline stay alike.
void make_planes_differ(const ProxyMesh& proxy, FlatPatches& flats);

}  // namespace burin::field
