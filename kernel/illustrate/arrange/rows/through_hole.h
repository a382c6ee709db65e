#pragma once
// Holes that have no depth; internal to the module.

#include <burin/base/run_context.h>
#include <burin/measure/feature.h>
#include <burin/surface/surface.h>

namespace burin::detail {

/// Whether a hole is open at both ends: whether along its wall nothing of its part is within a
/// radius beyond them. Cost: that of an Occluder of the part.
bool goes_through(const Surface& part, const Feature& hole, const RunContext& context);

}  // namespace burin::detail
