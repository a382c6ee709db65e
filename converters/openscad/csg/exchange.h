#pragma once
// What the evaluator's process and its parent hand each other through a file in memory; for
// converters/openscad alone.

#include "solid.h"

#include <string>
#include <string_view>
#include <vector>

namespace burin::csg {

/// Behind "line N" at the beginning of what is said of a node.
inline constexpr std::string_view kOfTree = " of the evaluated tree: ";

/// Writes all of a file that is open for reading and writing, what was in it gone. Throws Error.
void write_text(int descriptor, const std::string& text);
std::string read_text(int descriptor);

void write_solids(int descriptor, const std::vector<Solid>& solids);
/// Throws Error where the bytes are none that `write_solids` wrote.
std::vector<Solid> read_solids(int descriptor);

}  // namespace burin::csg
