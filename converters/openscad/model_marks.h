#pragma once
// What modifiers and burin.scad ask of the drawing; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/converters/read_result.h>

#include "parts.h"

#include <vector>

namespace burin::detail {

/// Without the name of the file. `made`: whether something came of each part; of others nothing is
/// asked. What says nothing useful is told.
ModelMarks marks_of(const TreeParts& parts, const std::vector<bool>& made,
                    Diagnostics& diagnostics);

}  // namespace burin::detail
