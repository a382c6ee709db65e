#pragma once
// Bodies of parts that a plan chooses; internal to the room.

#include <burin/converters/request.h>

#include <vector>

namespace burin::detail {

/// Splits the parts of which a selector of the plan names a body. `styles` are made as many as
/// there are parts then; bodies have that of their part.
void split_parts(Scene& scene, const DrawPlan& plan, std::vector<PartStyle>& styles);

/// Splits parts of which some bodies can be looked through and others not, where the steps of an
/// exploded view are known: the bodies of a part move as it does. `moves`: one a part, to which
/// those of bodies are added; styles of the plan likewise.
void split_glazed(Scene& scene, DrawPlan& plan, std::vector<Vec3>& moves);

}  // namespace burin::detail
