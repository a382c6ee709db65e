#pragma once
// Circles on which equal holes stand; internal to the module.

#include <burin/base/vec.h>

#include <cstddef>
#include <span>
#include <vector>

namespace burin::detail {

/// A turned face that is seen along its axis, in the plane of the sheet, paper mm.
struct Round {
  Vec2 center{0};
  double radius = 0;
  bool hollow = false;
  /// Of the part whose largest face this is.
  int part = -1;
};

struct PitchCircle {
  Vec2 center{0};
  double radius = 0;
  /// Which of the rounds stand on it.
  std::vector<std::size_t> holes;
};

/// The circles of three and more equal holes of one part: those about another round of that part,
/// and those of all equal holes that stand at equal angles (four of these are a square, which is
/// none). No hole stands on two.
std::vector<PitchCircle> pitch_circles(std::span<const Round> rounds);

}  // namespace burin::detail
