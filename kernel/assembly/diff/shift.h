#pragma once
// How far a part that has changed was moved, too; internal to the module.

#include <burin/congruence/body.h>

namespace burin::detail {

/// The shift that lays most of a shape on a changed one, none where shifts gain less than 2 %; and
/// the share of both surfaces that then lies on the other's.
struct Shift {
  Vec3 by{0};
  double share = 1;
};
Shift best_shift(const Body& before, const Body& after, double place);

}  // namespace burin::detail
