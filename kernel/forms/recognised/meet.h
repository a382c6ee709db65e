#pragma once
// Points on several surfaces at once; internal to the room.

#include "recognise.h"

#include <vector>

namespace burin::recognised {

/// A patch (>= 0) or the plane of a facet (~facet).
using SurfaceRef = std::int32_t;

class Meeting {
 public:
  Meeting(const Recognised& round, const Facets& facets) : round_(round), facets_(facets) {}

  /// The point on all surfaces of `refs` near `p`; returns false, and leaves `p`, where there is
  /// none nearer than a few sagittas.
  bool operator()(const std::vector<SurfaceRef>& refs, Vec3& p) const;
  Vec3 normal(SurfaceRef ref, Vec3 p) const;
  /// Largest distance between facets and surface; 0 for planes.
  double sagitta(SurfaceRef ref) const;

 private:
  double distance(SurfaceRef ref, Vec3 p, Vec3& normal) const;
  /// Where surfaces go over into one another but do not quite touch: between them.
  bool between(const std::vector<SurfaceRef>& refs, Vec3& p) const;

  const Recognised& round_;
  const Facets& facets_;
};

}  // namespace burin::recognised
