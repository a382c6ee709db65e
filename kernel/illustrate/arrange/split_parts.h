#pragma once
// Bodies of parts that an illustration chooses; internal to the module.

#include <burin/arrange/illustration.h>

#include <vector>

namespace burin::detail {

/// Splits parts of which some bodies can be looked through and others not, where the steps of an
/// exploded view are known: the bodies of a part move as it does. `moves`: one a part, to which
/// those of bodies are added; styles of the illustration likewise.
void split_glazed(Scene& scene, Illustration& illustration, std::vector<Vec3>& moves);

}  // namespace burin::detail
