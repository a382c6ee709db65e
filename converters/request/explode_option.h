#pragma once
// What exploded views take as text; internal to the room.

#include <burin/converters/request.h>
#include <burin/explode/explode.h>

#include <string>
#include <vector>

namespace burin::detail {

/// "auto", "none", an axis x, y or z with or without a sign, or X,Y,Z. Steps that were given are
/// gone. Throws UsageError.
void set_explode(Explode& explode, const std::string& spelled, const std::string& text);

/// The steps of a file, or those that are found. Throws UsageError where a selector names nothing.
std::vector<ExplodeStep> steps_of(Scene& scene, const Explode& explode,
                                  const std::vector<bool>& drawn, const ExplodeModel& model,
                                  RunContext& context);

}  // namespace burin::detail
