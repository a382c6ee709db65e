#pragma once
// Which calls of modules are parts of their own; internal to the module.

#include "parts.h"
#include "solid_store.h"

#include <string>
#include <string_view>

namespace burin::detail {

/// Where loops, blocks and modules put several things beside each other, each call is a part: those
/// of the program's own statements unless one runs into another, those within a module unless they
/// touch; an object some of whose solids are no call's, or a module that calls itself, is one
/// thing, and so is what part() and callout() hold. All that has to be
/// compared is evaluated in `store`; what the evaluation of the objects as they are says of
/// the model goes to `diagnostics`. More than kMostInstances are not parted, which is told. Throws
/// as `SolidStore::store`.
CallParts instances_of(const csg::Tree& tree, const TreeCalls& calls, std::string_view program,
                       const std::string& stem, SolidStore& store, Diagnostics& diagnostics);

inline constexpr std::size_t kMostInstances = 1000;

}  // namespace burin::detail
