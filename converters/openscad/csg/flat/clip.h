#pragma once
// Boolean operations, offsets and sums of regions, on the grid of integers that OpenSCAD gives to
// Clipper; for converters/openscad alone.

#include <burin/base/vec.h>

#include "solid.h"

#include <span>
#include <vector>

namespace burin::csg {

/// Grid units a mm, as in OpenSCAD: what is nearer together than one becomes the same.
inline constexpr double kGrid = 65536;

class Origins;

enum class ClipOp { Union, Difference, Intersection };

/// All functions: points of the result that are points of an operand have its coordinates to the
/// bit, others lie on the grid; edges on a tagged edge of an operand get its arc. They throw
/// InputError where coordinates are beyond 1e12 mm or no numbers. Cost: n log n
/// for n edges and crossings; a run cannot be cancelled inside one of them.

/// The places that outlines of any winding, which may cross, go around an odd number of times.
Region odd_places(const Region& outlines);

/// The first region with the rest; a place is inside an operand where its outlines wind around it
/// at all (glyphs may be clockwise).
Region clip(ClipOp op, std::span<const Region> operands);

/// What triangles of either orientation cover.
Region covered(std::span<const Outline> triangles, const Origins& origins);

struct OffsetRule {
  enum class Corner { Round, Sharp, Cut } corner = Corner::Round;
  /// How far round corners may be from their arc, mm.
  double tolerance = 0;
  /// Corners of a whole circle of radius |delta|.
  int fragments = 0;
};
/// Moves the boundary outwards by `delta` mm (inwards where negative). Throws InputError where
/// round corners would have more than ten million points.
Region offset_region(const Region& region, double delta, const OffsetRule& rule);

/// Minkowski sum. Throws InputError where more than four million pairs of edges would be joined.
Region minkowski_sum(const Region& a, const Region& b);

/// Convex hull of the outlines of all.
Region hull_of(std::span<const Region> regions);

}  // namespace burin::csg
