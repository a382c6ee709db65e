#pragma once
// In which order, which way and how far; internal to the module.

#include <burin/base/run_context.h>
#include <burin/explode/explode.h>

#include "blocking.h"
#include "contacts.h"
#include "shapes.h"

#include <vector>

namespace burin::detail {

/// All that the order is decided by.
struct Situation {
  const Shapes& shapes;
  const std::vector<AxisView>& views;
  const std::vector<std::vector<Neighbour>>& neighbours;
  const ExplodeOptions& options;
  const RunContext& context;

  /// A direction is an axis, or the way back along it.
  std::size_t directions() const { return 2 * views.size(); }
  bool allowed(std::size_t direction) const { return !options.one_way || direction % 2 == 0; }
  Vec3 along(std::size_t direction) const {
    const Vec3 axis = views[direction / 2].axis();
    return direction % 2 == 0 ? axis : -axis;
  }
  const AxisView& view(std::size_t direction) const { return views[direction / 2]; }
  /// Where a box begins and ends along a direction.
  Vec2 reach(std::size_t direction, const Box3& box) const {
    return direction % 2 == 0 ? Vec2(box.min.z, box.max.z) : Vec2(-box.max.z, -box.min.z);
  }
  Vec2 reach(std::size_t direction, const Column& column) const {
    return direction % 2 == 0 ? Vec2(column.from, column.to) : Vec2(-column.to, -column.from);
  }
};

/// What moves as one on a level of the assembly: a part, or several.
struct Node {
  std::vector<std::size_t> parts;
  /// Names of assemblies above what is in it.
  std::size_t depth = 0;
  /// What it was made of where it is no assembly.
  std::vector<Node> members = {};
  /// Its parts do not come apart.
  bool locked = false;
};

/// Nodes that leave a level together.
struct Removal {
  std::vector<Node> nodes;
  std::size_t direction = 0;
};

/// One level taken apart.
struct Level {
  /// In order.
  std::vector<Removal> removals;
  Node base;
  std::vector<std::vector<std::size_t>> interlocked;
};

/// What an assembly, or what moved as one, is made of; one node where it does not come apart.
std::vector<Node> inside(const Node& node, const Shapes& shapes);

Level take_apart(std::vector<Node> nodes, const Situation& situation);

/// Whether boxes of two parts overlap across an axis by more than they may lie in each other.
bool overlap_across(const Box3& a, const Box3& b, double eps);

}  // namespace burin::detail
