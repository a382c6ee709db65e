#pragma once
// What exploded views take as text; internal to the module.

#include <burin/arrange/illustration.h>

#include <string>

namespace burin::detail {

/// "auto", "none", an axis x, y or z with or without a sign, or X,Y,Z. Steps that were given are
/// gone. Throws UsageError.
void set_explode(Explode& explode, const std::string& spelled, const std::string& text);

}  // namespace burin::detail
