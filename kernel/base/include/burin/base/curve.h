#pragma once
/// A line in space that may be drawn. Strokes and feature lines are both of this type, so that
/// visibility treats them alike.

#include <burin/base/ids.h>
#include <burin/base/vec.h>

#include <cstdint>
#include <string>
#include <vector>

namespace burin {

/// What a line is; the names are those of the drawing file's `kind`. Burin itself makes contours,
/// boundaries, creases, smooth edges, seams, intersections, sections, isophotes (lines of equal
/// light), patterns, strokes, trails of exploded views, centre lines, the thin lines of threads and
/// the wide ones where these end. The drawing file has names for more, which other programs may
/// write and `burin convert` passes on: ridges, valleys and suggestive contours. Leaders (with
/// their dots and arrows) and frames (of numbers and tables) are laid out over a drawing and lie on
/// no surface.
enum class LineClass {
  Contour,
  Boundary,
  Crease,
  Smooth,
  Seam,
  Intersection,
  Section,
  Ridge,
  Valley,
  Suggestive,
  Isophote,
  Stroke,
  Pattern,
  Trail,
  Centre,
  Thread,
  ThreadEnd,
  Leader,
  Frame
};
inline constexpr LineClass kLastLineClass = LineClass::Frame;

/// The name of a kind in the drawing file, e.g. "contour".
const char* to_string(LineClass kind);

/// A polyline on (or along the edge of) one part's surface, in model coordinates.
///
/// `points` has n >= 2 entries; a closed curve does not repeat its first point and has n segments
/// (segment i joins points[i] and points[(i+1) % n]), an open one has n-1. The per-point and
/// per-segment arrays are either empty or of exactly that size.
struct Curve3 {
  std::vector<Vec3> points;
  /// One per point: unit vector to the open side, where no surface of the curve's own sheet lies
  /// (the surface normal for strokes and contours, the mean of both normals for creases).
  /// Visibility rays start a little along it.
  std::vector<Vec3> normals;
  /// One per segment: a triangle of the part's proxy that the segment lies on or bounds; -1 where
  /// unknown.
  std::vector<std::int32_t> faces;
  /// One per segment: nonzero where the curve's own sheet is known to hide it (both neighbours of
  /// an edge face away on a closed surface; a fold whose far side is in front). No ray is cast
  /// there.
  std::vector<std::uint8_t> self_hidden;
  /// One per point: width in paper mm. Empty for features, whose width is the style's.
  std::vector<double> widths;

  LineClass kind = LineClass::Stroke;
  SourceId source;
  bool closed = false;
  /// Whether the surface ends or folds here in the picture, so that what lies behind may change
  /// visibility: contours, boundaries and creases between a face turned to the viewer and one
  /// turned away.
  bool occluding = false;
  /// Drawn where it is the border of the object alone: where a cut goes on in another plane, what
  /// lies behind is seen as if both were one.
  bool border_alone = false;
  /// Creases: +1 convex, -1 concave, 0 otherwise.
  int crease_sign = 0;
  /// Strokes: 1 or 2, the family of the direction field.
  int family = 0;
  /// Strokes: which kind of strokes of the style, from 1.
  int stroke_kind = 1;

  std::size_t segment_count() const { return closed ? points.size() : points.size() - 1; }
  std::size_t next(std::size_t i) const { return i + 1 == points.size() ? 0 : i + 1; }

  bool operator==(const Curve3&) const = default;
};

}  // namespace burin
