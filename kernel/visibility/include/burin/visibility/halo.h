#pragma once
/// Haloed lines: where a line passes behind another, a gap in it says so.

#include <burin/base/run_context.h>
#include <burin/base/vec.h>

#include <span>
#include <vector>

namespace burin {

/// A stretch of a line between two parameters (segment index plus share of the segment in space).
struct HaloGap {
  double begin = 0;
  double end = 0;
};

/// A stretch that stands before what lies behind it.
struct HaloCaster {
  double begin = 0;
  double end = 0;
  /// Paper mm from the line to the edge of its ink, before `HaloLine::scale`.
  double half_width = 0;
};

/// A polyline of the picture; a closed one does not repeat its first point. Hidden stretches
/// belong to it: a visible line that ends at a nearer one goes on behind it, and the two cross.
struct HaloLine {
  std::vector<Vec2> points;
  /// A point: model mm, larger is nearer.
  std::vector<double> depths;
  /// A point: distance from the viewer along the axis of the view. Empty = orthographic.
  std::vector<double> ranges;
  /// A point: factor of the half widths. Empty = 1.
  std::vector<double> scale;
  /// A point, for lines on a surface (strokes): model mm of depth that the surface changes by a
  /// paper mm. Such lines also end where they come near a nearer line without crossing it; the
  /// slope tells their own sheet, which bounds at that line, from a sheet behind. Empty = features.
  std::vector<double> slopes;
  bool closed = false;
  /// What of the line is drawn and interrupts lines behind it.
  std::vector<HaloCaster> casters;
  /// Whether nearer lines interrupt it, and the paper mm that its ink passes its ends (round caps).
  bool interrupted = true;
  double overhang = 0;
};

struct HaloOptions {
  /// Paper mm of white beside the ink of the nearer line, at a right angle to that line.
  double gap = 0.5;
  /// Model mm: a line is behind another if it is farther by more than this. Steep lines need more:
  /// what 0.05 mm of paper change their depth.
  double behind = 0;
};

/// The stretches of each line that are to be left out: sorted, apart, within [0, segment count].
/// A stretch is left out where the line is nearer on paper to a caster than the caster's half
/// width, the gap and its own overhang, as far as it stays that near on both sides of a place where
/// it crosses the caster behind it: two straight lines that cross at an angle w give a gap of
/// 2 * distance / sin(w). Lines that meet at one depth (at a common vertex, a stroke at the contour
/// of its own sheet) leave each other alone, and so does a line itself within three such distances
/// of its own course. Deterministic for any number of threads; throws Cancelled. Cost: about 1 us a
/// segment.
/// @cite Appel1979
std::vector<std::vector<HaloGap>> halo_gaps(std::span<const HaloLine> lines,
                                            const HaloOptions& options, const RunContext& context);

}  // namespace burin
