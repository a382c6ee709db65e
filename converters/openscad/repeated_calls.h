#pragma once
// Finds calls that repeat an earlier call in the same place; private to this module.

#include "calls.h"
#include "tree.h"

#include <cstdint>
#include <set>

namespace burin::detail {

/// Nodes of calls that make the same thing in the same place and colour as an earlier call, as the
/// last turn of `for (a = [0:60:360]) rotate(a)` does. Linear in the text times its depth.
std::set<std::uint32_t> repeated_calls(const csg::Tree& tree, const TreeCalls& calls);

}  // namespace burin::detail
