#pragma once
/// Screw threads of parts: what of them is known, and on which face of the part they are.

#include <burin/base/placement.h>
#include <burin/surface/turned_faces.h>

#include <cstdint>
#include <string>

namespace burin {

/// A thread on a shaft or in a hole that is modelled as a plain cylinder: a shaft as wide as the
/// crests, a hole as wide as the drill. Model mm, where the part stands.
struct Thread {
  Axis axis;
  /// Along the axis from its point: from where to where, `begin` below `end`.
  double begin = 0, end = 0;
  /// Radii: to the crests and to the roots of a screw, to the roots and to the crests of a hole.
  double major = 0, minor = 0;
  /// In a hole.
  bool internal = false;
  /// As people write it: "M6".
  std::string designation = {};

  /// The face that it is on, as `ProxyMesh::face_source` numbers it; -1: not found yet, and it is
  /// not drawn.
  std::int32_t face = -1;
  /// The radius of that face.
  double modelled = 0;
  /// Whether the solid of a screw ends at that end of the thread, or the hole opens there.
  bool open_begin = false, open_end = false;

  /// The radius that no face of the part has: of the lines that stand for the thread.
  double thin() const { return internal ? major : minor; }

  bool operator==(const Thread&) const = default;
};

/// The thread of a part that was placed elsewhere. A placement that stretches leaves no thread a
/// thread: it has the mean scale.
Thread placed(const Thread& thread, const Placement& by);

}  // namespace burin
