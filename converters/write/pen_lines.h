#pragma once
// Lines as a pen draws them: with few points, in dashes; discs as circles.

#include <burin/base/vec.h>

#include <vector>

namespace burin {

/// Paper mm that a line may be from its points: a little beside the 0.018 that rounding to the
/// units of a plotter adds.
constexpr double kThinned = 0.005;
/// Paper mm between an arc and the chords of points that were thinned so.
constexpr double kChords = 0.012;

/// A line without the points that it does not need within kThinned.
std::vector<Vec2> thinned(const std::vector<Vec2>& all);

/// The pieces of a line that are drawn where ink and gaps alternate; a closed line repeats its
/// first point at its end.
std::vector<std::vector<Vec2>> dashes_of(const std::vector<Vec2>& line,
                                         const std::vector<double>& lengths);

/// Its dashes, fitted to the length of its arcs, which is a little more than that of their chords.
std::vector<std::vector<Vec2>> dashes_along(const std::vector<Vec2>& line,
                                            std::vector<double> dashes);

/// Circles about a place, one inside the other, and its middle, that a pen fills a disc with; none
/// where the pen is as wide as the disc.
std::vector<std::vector<Vec2>> disc_of(Vec2 middle, double diameter, double pen);

}  // namespace burin
