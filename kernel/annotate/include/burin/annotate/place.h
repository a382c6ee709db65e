#pragma once
/// Where numbers stand about a drawing, so that no leaders cross.

#include <burin/annotate/options.h>
#include <burin/base/box.h>
#include <burin/base/run_context.h>
#include <burin/base/vec.h>

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace burin {

/// Sizes that follow from the height of numbers and the widest of them, paper mm.
struct CalloutSizes {
  /// Of the circle; without one, of the room that a number has.
  double diameter = 10;
  /// Least distance of neighbours, middle to middle.
  double pitch = 14;
  /// Between the drawing and the circles.
  double gap = 6;

  CalloutSizes(const CalloutOptions& options, int largest_number);
};

/// The middles of the numbers, in the order of the anchors.
struct CalloutPlaces {
  std::vector<Vec2> at;
  /// Pairs that changed places until no change shortened the leaders.
  std::size_t swaps = 0;
  /// How much larger the sheet must be for all to have their pitch; 1 where they have.
  double lacking = 1;
  /// Least distance of neighbours that they have: the pitch, or less where that has no room.
  double pitch = 0;
  /// There were so many that leaders may cross.
  bool unfinished = false;
};

/// What a leader meets.
struct LeaderCosts {
  /// Paper mm of it that run along the strokes of the drawing below it.
  std::function<double(Vec2 from, Vec2 to)> along = {};
  /// Other annotations that it passes over; 1 is as bad as the anchor of another number.
  std::function<double(Vec2 from, Vec2 to)> over = {};
};

/// Puts a number for each anchor on a rectangle about the drawing, inside `frame`: columns first,
/// then rows, or as the layout has it. Any numbers change places while that makes their two leaders
/// shorter in sum; at the end no two leaders cross, as a pair that crosses always gets shorter.
/// Then they slide along their side towards their anchors (isotonic regression at the least pitch).
/// Leaders that pass over another's anchor or other annotations, or run along strokes, give way
/// where that makes none cross. Where leaders still pass over other annotations, numbers are shared
/// otherwise between the two sides if that is better, up to 100 of them. Numbers that have no room
/// stand closer than the pitch, and `lacking` says how much larger the frame must be. Rounds are
/// bounded; the same places for the same anchors. Throws Cancelled. Cost: 5 ms for 100 anchors.
/// @cite Barlow1972
CalloutPlaces place_callouts(std::span<const Vec2> anchors, const Box2& drawing, const Box2& frame,
                             const CalloutSizes& sizes, CalloutOptions::Layout layout,
                             const RunContext& context, const LeaderCosts& costs = {});

/// How many numbers have their pitch on each side.
struct CalloutCapacity {
  std::size_t column = 0, row = 0;
};
CalloutCapacity callout_capacity(const Box2& drawing, const Box2& frame, const CalloutSizes& sizes);

/// Whether all of them have their pitch.
bool callouts_fit(std::size_t count, const Box2& drawing, const Box2& frame,
                  const CalloutSizes& sizes, CalloutOptions::Layout layout);

/// Whether two stretches cross or touch.
bool segments_cross(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// The numbers that come nearest to the given ones with neighbours at least `pitch` apart, in their
/// order, from `low` to `high`, which have that space. @cite Barlow1972
std::vector<double> spread(std::span<const double> wanted, double pitch, double low, double high);

}  // namespace burin
