#pragma once
// The zeros of a function over a proxy as lines.

#include <burin/base/curve.h>
#include <burin/base/run_context.h>

#include "zero_set.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace burin {

/// Where a segment of a line enters its triangle and where it leaves it (barycentric).
struct Chord {
  Vec3 in, out;
};

/// A line with the front side to its left, one segment a triangle; segments of no length are left
/// out. Ends lie on creases and boundaries.
struct ZeroLine {
  std::vector<Vec3> points, normals;
  std::vector<std::int32_t> faces;
  /// One a segment, where they were asked for.
  std::vector<Chord> chords;
  bool closed = false;
  /// The triangle that it was found in.
  std::uint32_t first_face = 0;

  /// As a curve of a kind and part, in the region of that triangle; all but the chords moves there.
  /// No segment hides itself.
  Curve3 take_curve(const ZeroSet& zeros, LineClass kind, std::int32_t part);
};

/// Calls `each` with every line of more than a point: open ones first, by their first triangles.
/// Points are bit for bit those of `ZeroSet::crossing`.
void trace_zeros(const ZeroSet& zeros, bool with_chords, const RunContext& context,
                 const std::function<void(ZeroLine&&)>& each);

/// Puts points on the smooth surface between those on the edges of the mesh, wherever a chord would
/// show: the surface over a triangle is not flat. `flags`: one a segment, kept in step.
void follow_surface(const ZeroSet& zeros, const std::vector<Chord>& chords, Curve3& curve,
                    std::vector<std::uint8_t>& flags);

}  // namespace burin
