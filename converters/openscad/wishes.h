#pragma once
// What modifiers and burin.scad ask of the drawing; internal to the module.

#include <burin/base/diagnostics.h>

#include "parts.h"

#include <string>
#include <vector>

namespace burin::detail {

/// The text of an illustration without parts, or empty. `made`: whether something came of each
/// part; of others nothing is asked. What says nothing useful is told.
std::string settings_of(const TreeParts& parts, const std::vector<bool>& made,
                        Diagnostics& diagnostics);

}  // namespace burin::detail
