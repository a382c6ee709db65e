#pragma once
/// Lines that are put together: rings, and lines in the order in which a pen travels little.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>

#include <deque>
#include <functional>
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
  std::deque<Path> made;
};

/// Joins open paths of one constant width, visibility and dash whose ends meet two by two all
/// round, within 0.003 mm. A ring has the source and kind of its longest piece; one that `wanted`
/// refuses stays in its pieces. Points into `paths`.
JoinedPaths join_rings(std::span<const Path* const> paths,
                       const std::function<bool(const Path& ring)>& wanted = {});

/// The paths in the order of `pen_order`: lines of one constant width, visibility and dash are
/// joined where they meet, those that vary in width stay as they are; any may be turned round, and
/// closed ones begin elsewhere. What is made anew has the source and kind of its longest piece and
/// no model points. `from`: where the pen stands, then where it stands afterwards. Points into
/// `paths`, each of which has two points or more. Throws Cancelled. Cost: as `pen_order`.
JoinedPaths in_travel_order(std::span<const Path* const> paths, Vec2& from,
                            const RunContext& context);

}  // namespace burin
