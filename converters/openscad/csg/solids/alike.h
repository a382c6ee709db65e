#pragma once
// What stands in several places and is cut once; for csg/solids alone.

#include "gather.h"

#include <vector>

namespace burin::csg {

/// What some children of a gathered shape's node 0 are: the innermost union that holds them all,
/// and which of its children they are. Equal keys: the same thing, moved by `matrix`.
struct Alike {
  std::vector<std::uint32_t> key;
  /// Of the gathered matrices: where that union stands.
  std::uint32_t matrix = 0;
};

/// `children`: numbers in `all.children`, ascending, at least one.
Alike alike(const Gather& all, std::span<const std::uint32_t> children);

}  // namespace burin::csg
