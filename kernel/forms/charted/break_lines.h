#pragma once
// Where the parametrisation of a face breaks.

#include <burin/forms/charted/atlas.h>

#include <array>
#include <limits>
#include <vector>

namespace burin::detail {

/// The whole plane of (u,v).
inline constexpr ParameterBox kUnbounded{Vec2(-std::numeric_limits<double>::infinity()),
                                         Vec2(std::numeric_limits<double>::infinity())};

/// The lines of (u,v) at which S is continuous and its partial derivatives are not (knots of full
/// multiplicity, and the seams of periodic faces where they are such). The surface may well be
/// smooth there, or have a crease.
class BreakLines {
 public:
  explicit BreakLines(const Atlas& atlas);

  bool none(std::int32_t face) const { return !any_ || of(face).none(); }
  /// The cell between neighbouring lines around a place; on a line the one that `velocity` leads
  /// into.
  ParameterBox cell(std::int32_t face, Vec2 uv, Vec2 velocity) const;
  /// The share of the straight way between two places at which it crosses the line nearest to its
  /// middle; 0.5 where it crosses none.
  double crossing(std::int32_t face, Vec2 from, Vec2 to) const;
  /// The place put on the lines that it lies on within rounding.
  Vec2 snap(std::int32_t face, Vec2 uv) const;
  /// Whether both places lie on one line.
  bool along_line(std::int32_t face, Vec2 from, Vec2 to) const;
  /// Distances in (u,v) below this are rounding.
  Vec2 noise(std::int32_t face) const { return of(face).noise; }

 private:
  struct Face {
    std::array<std::vector<double>, 2> lines;
    Vec2 start{0}, period{0}, noise{0};
    bool none() const { return lines[0].empty() && lines[1].empty(); }
  };
  /// The line nearest to x; NaN where there is none.
  static double nearest(const Face& f, int direction, double x);
  const Face& of(std::int32_t face) const { return faces_[static_cast<std::size_t>(face)]; }

  std::vector<Face> faces_;
  bool any_ = false;
};

}  // namespace burin::detail
