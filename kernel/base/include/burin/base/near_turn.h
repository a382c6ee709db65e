#pragma once
/// Placements as files have them, with a few digits.

#include <burin/base/placement.h>

#include <optional>

namespace burin {

/// The nearest placement that turns or mirrors, scales alike in all directions and moves, where
/// `place` is within 3e-6 of one, which is what six digits leave of a matrix; a scale that near to
/// 1 is 1. Nothing where `place` stretches or shears.
std::optional<Placement> near_turn(const Placement& place);

}  // namespace burin
