#pragma once
// What some styles and kinds of strokes have in common; internal to the module.

#include <burin/illustrate/style.h>

namespace burin::detail {

/// Dots that no neighbour comes too near.
void dotted(HatchStyle& hatch);

/// Short, thin strokes.
void pencilled(HatchStyle& hatch);

}  // namespace burin::detail
