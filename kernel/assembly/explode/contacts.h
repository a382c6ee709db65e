#pragma once
// Where parts touch; internal to the module.

#include <burin/base/run_context.h>
#include <burin/visibility/occluder.h>

#include "shapes.h"

#include <vector>

namespace burin::detail {

/// A face of one part that touches another part.
struct Contact {
  std::size_t part = 0, other = 0;
  /// Normal of a plane, axis of a cylinder or cone; zero of neither.
  Vec3 axis{0};
  bool round = false;
  /// In the middle of what touches; on the axis where the face is round.
  Vec3 middle{0};
  /// Model mm2 that touch, roughly.
  double area = 0;
};

/// Contacts of all parts, those of a part with another next to each other, ascending. Parts that
/// come as near as 1 % of the smaller one's diagonal touch: screws in clearance holes do.
/// 1024 points a part.
std::vector<Contact> find_contacts(const Shapes& shapes, const Occluder& occluder,
                                   const RunContext& context);

/// A part that touches another, on how much area.
struct Neighbour {
  std::size_t part = 0;
  double area = 0;
};

/// For each part the parts that touch it, ascending.
std::vector<std::vector<Neighbour>> neighbours_of(const std::vector<Contact>& contacts,
                                                  std::size_t count);

}  // namespace burin::detail
