#pragma once
/// Which direction of a cross belongs to family 1.

#include <burin/surface/surface.h>

#include "constraints.h"

#include <vector>

namespace burin::field {

/// For each wedge the line of family 1 (a unit complex number, the direction to the second power):
/// one of the two lines of its cross, chosen so that neighbours agree wherever the field has no odd
/// singularity between them, and otherwise near the target. `kinds`: of the face of each triangle,
/// or none; families change names on a cylinder, cone or torus only where they cannot elsewhere.
/// `flats`, unless null, take part: the
/// families of its patches are exchanged so that they agree with those of the surface behind their
/// smooth borders, and small fillets follow the large planes that they join.
std::vector<Vec2> choose_family(const ProxyMesh& proxy, const WedgeGraph& graph,
                                const std::vector<Vec2>& crosses, const Constraints& targets,
                                const std::vector<FaceKind>& kinds, FlatPatches* flats,
                                const RunContext& context);

/// Exchanges the families of flat parts whose smooth borders mostly name the other arm, so that
/// strokes go on over them.
void match_flat_families(const ProxyMesh& proxy, const WedgeGraph& graph,
                         const std::vector<Vec2>& lines, FlatPatches& flats);

}  // namespace burin::field
