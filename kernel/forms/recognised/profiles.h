#pragma once
// Smooth profiles of surfaces of revolution; internal to the module.

#include "revolution.h"

#include <vector>

namespace burin::recognised {

/// A segment so many times longer than its neighbour is a line that the neighbour runs into.
inline constexpr double kLong = 2.5;

/// One piece of a profile polygon, in the plane of its chain: a line with its outward normal, and
/// the ends of its chord in the order of Patch::along.
struct Segment {
  Vec2 normal{1, 0};
  double offset = 0;
  Vec2 begin{0}, end{0};
  /// Whether an end is a joint with the neighbour in the list (or a mirrored one) and so known, or
  /// as far as the mesh reaches.
  bool begin_known = false, end_known = false;

  Vec2 along() const { return {-normal.y, normal.x}; }
  double length() const { return glm::length(end - begin); }
};

/// Angle by which the profile turns from `a` to `b`, positive where it bends away from the outside.
double turn_between(const Segment& a, const Segment& b);

/// What else is smooth among the joints of a profile.
struct TurnRule {
  /// By how much of themselves turns of more than 15 degrees may differ from a neighbour.
  double unequal = 0.1;
  /// Whether a curve may bend back and forth: a turn halfway between those before and after it goes
  /// on.
  bool waves = false;
};
/// The rule of `smooth_joints` for the angles at joints alone.
std::vector<bool> smooth_turns(const std::vector<double>& turn, bool closed,
                               const TurnRule& rule = {});

/// For each joint between segment i and i + 1 (closed: the last to the first, too) whether the
/// profile goes on smoothly there: three joints in a row at the least, none much larger than its
/// neighbours, and those of more than 15 degrees equal.
std::vector<bool> smooth_joints(const std::vector<Segment>& segments, bool closed);

/// Gives the patches of a run of segments that are smooth at their joints their curves: circles
/// where the joints lie on one, lines where a long segment carries on, else cubics. Patches have
/// the axis and line of their segment already. `noise` in mm.
void bend(const std::vector<Segment>& segments, bool closed, double noise,
          std::vector<Patch*> patches);

}  // namespace burin::recognised
