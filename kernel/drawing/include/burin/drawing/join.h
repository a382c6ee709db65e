#pragma once
/// Lines that close when they are put together.

#include <burin/drawing/drawing.h>

#include <deque>
#include <span>
#include <vector>

namespace burin {

/// Paths as they are to be drawn: those that were given, in their order, but for each ring of them
/// one closed path, which stands where the first of the ring stood.
struct JoinedPaths {
  std::vector<const Path*> paths;
  /// What each of them was made of; empty for a path as it was given.
  std::vector<std::vector<const Path*>> pieces;
  /// The new ones.
  std::deque<Path> rings;
};

/// Joins open paths of one constant width, visibility and dash whose ends meet two by two all
/// round, within 0.003 mm. A ring has the source and kind of its longest piece. Points into
/// `paths`.
JoinedPaths join_rings(std::span<const Path* const> paths);

}  // namespace burin
