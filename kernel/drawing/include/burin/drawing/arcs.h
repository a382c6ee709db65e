#pragma once
/// Circles, ellipses and their arcs in polylines.

#include <burin/base/vec.h>

#include <optional>
#include <span>
#include <vector>

namespace burin {

/// An arc of an ellipse, or of a circle. At the angle t (of the parameter, radians) it is at
/// center + cos(t) * major + sin(t) * ratio * (major turned by 90 degrees anticlockwise).
struct ConicArc {
  Vec2 center{0};
  /// From the centre to the end of the long half axis, paper mm; of a circle any radius.
  Vec2 major{0};
  /// Short half axis over long one; 1: a circle.
  double ratio = 1;
  /// Where it begins, and how far it turns: positive is anticlockwise; 2 pi, to within 1e-9: a
  /// whole one.
  double begin = 0, turn = 0;

  Vec2 at(double t) const;
  bool is_circle() const { return ratio == 1; }
  bool is_whole() const;
  double radius() const { return glm::length(major); }
};

/// A stretch of a polyline: its points, and the arc from the first to the last of them where it is
/// one.
struct CurvePiece {
  std::vector<Vec2> points;
  std::optional<ConicArc> arc;

  /// Where it is drawn from and to: its first and last point; of a whole circle a place beside it.
  Vec2 start() const { return arc ? arc->at(arc->begin) : points.front(); }
  Vec2 end() const { return arc ? arc->at(arc->begin + arc->turn) : points.back(); }
};

struct ArcOptions {
  /// Paper mm between an arc and the points that it stands for: those of a curve are as exact as
  /// whoever computed it, so this may be small.
  double points = 0.002;
  /// Paper mm between an arc and the chords of its points: what is farther off is a polygon.
  double chords = 0.02;
  /// Ellipses too, not circles alone.
  bool ellipses = false;
  /// Any curve in arcs that are near enough, as machines want it. Else an arc ends where the line
  /// does, at a corner, or where the next point leaves it at once: others are no arcs.
  bool approximate = false;
};

/// Divides a polyline into the arcs in it and what is left between them; together they are the
/// polyline, in its order, each piece beginning with the last point of the one before. Arcs end
/// exactly on their first and last point (whole circles and ellipses: within `options.points`). An
/// arc stands for three segments or more (an ellipse for six) and bows by more than twice
/// `options.points` and a tenth of `options.chords`, a radius is up to 2 m. A closed polyline does
/// not repeat its first point; it may begin elsewhere in the pieces. One piece without an arc where
/// there is none. Points are finite. Cost: n log n fits of circles at the most, 1 us per point for
/// a circle.
/// @cite Halir1998
std::vector<CurvePiece> fit_arcs(std::span<const Vec2> points, bool closed,
                                 const ArcOptions& options);

}  // namespace burin
