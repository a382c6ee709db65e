#pragma once
// Bodies of parts that a plan chooses; internal to the room.

#include <burin/converters/request.h>

#include <vector>

namespace burin::detail {

/// Splits the parts of which a selector of the plan names a body. `styles` are made as many as
/// there are parts then; bodies have that of their part.
void split_parts(Scene& scene, const DrawPlan& plan, std::vector<PartStyle>& styles);

}  // namespace burin::detail
