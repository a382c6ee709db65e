#pragma once
// What dimensions take up on paper, and whether that lies on something; internal to the module.

#include <burin/base/box.h>
#include <burin/base/vec.h>

#include <array>
#include <span>
#include <vector>

namespace burin::detail {

enum class Stroke { Dimension, Extension, Leader };

/// A piece of a line.
struct PrintedPiece {
  Vec2 a{0}, b{0};
  Stroke stroke = Stroke::Dimension;
};

/// The box of letters, turned as they are: corners anticlockwise.
using Quad = std::array<Vec2, 4>;
/// `along` is unit, the way of the letters; `low` their left end on the base line.
Quad quad_of(Vec2 low, Vec2 along, double width, double height);
/// Larger by so much on all sides.
Quad grown(const Quad& quad, double by);

/// Convex outlines that share more than a border.
bool overlap(std::span<const Vec2> a, std::span<const Vec2> b);

/// How far the segment has to go along `way`, unit, until it is outside of a convex outline; 0
/// where it is.
double exit_of(Vec2 a, Vec2 b, Vec2 way, std::span<const Vec2> outline);

/// How often a piece crosses a line.
int crossings_of(const PrintedPiece& piece, std::span<const Vec2> line);

/// What one dimension takes up.
struct Footprint {
  std::vector<PrintedPiece> pieces;
  std::vector<Quad> letters;

  /// About all of it.
  Box2 box() const;
};

struct Conflicts {
  /// Letters on letters or lines, lines of dimensions on each other: never wanted.
  int hard = 0;
  /// Lines that cross.
  int crossings = 0;
};
/// `apart`: paper mm between lines of dimensions that run beside each other.
Conflicts conflicts_of(const Footprint& one, const Footprint& other, double apart);

}  // namespace burin::detail
