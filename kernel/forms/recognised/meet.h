#pragma once
// Points on several surfaces at once; internal to the module.

#include "recognise.h"

#include <span>

namespace burin::recognised {

/// A patch (>= 0) or the plane of a facet (~facet).
using SurfaceRef = std::int32_t;

class Meeting {
 public:
  Meeting(const Recognised& round, const Facets& facets) : round_(round), facets_(facets) {}

  /// The point on all surfaces of `refs` near `p`; returns false, and leaves `p`, where there is
  /// none nearer than a few sagittas.
  bool operator()(std::span<const SurfaceRef> refs, Vec3& p) const;
  /// Whether `p` is on all of them already, within a thousandth of a sagitta.
  bool holds(std::span<const SurfaceRef> refs, Vec3 p) const;
  Vec3 normal(SurfaceRef ref, Vec3 p) const;
  /// Largest distance between facets and surface; 0 for planes.
  double sagitta(SurfaceRef ref) const;

 private:
  double distance(SurfaceRef ref, Vec3 p, Vec3& normal) const;
  double largest_sagitta(std::span<const SurfaceRef> refs) const;
  /// The shortest step that takes `p` onto all surfaces, to first order; `worst` is the largest
  /// distance from one. For one or two in closed form.
  Vec3 step_to_both(std::span<const SurfaceRef> refs, Vec3 p, double& worst) const;
  Vec3 step_to_all(std::span<const SurfaceRef> refs, Vec3 p, double& worst) const;
  /// Where surfaces go over into one another but do not quite touch: between them.
  bool between(std::span<const SurfaceRef> refs, Vec3& p) const;

  const Recognised& round_;
  const Facets& facets_;
};

}  // namespace burin::recognised
