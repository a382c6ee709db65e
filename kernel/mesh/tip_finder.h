#pragma once
/// Finds vertices at the tips of cones and fans; private to this module.

#include "build_steps.h"

#include <vector>

namespace burin {

/// Looks at fans: the triangles around a vertex as far as the next crease. Follows `edge_kind` as
/// it is when asked.
class TipFinder {
 public:
  /// `crease_angle` in radians.
  TipFinder(const ProxyMesh& proxy, const std::vector<Vec3>& normals, double crease_angle)
      : proxy_(proxy), normals_(normals), crease_angle_(crease_angle) {}

  /// The first corner of the fan of `h`, clockwise, after a crease; `h` where there is none.
  HalfEdge first_of(HalfEdge h) const;
  /// Whether the fan from `first` on has no one normal: it leans as a cone does, and is not round
  /// beyond.
  bool is_tip(HalfEdge first) const;
  /// Labels the corners of the fan by its flat faces, from 0 on.
  void label(HalfEdge first, std::vector<std::uint32_t>& labels) const;

 private:
  bool smooth(HalfEdge h) const {
    return proxy_.edge_kind[static_cast<std::size_t>(h)] == EdgeKind::Smooth;
  }
  HalfEdge next(HalfEdge h, HalfEdge first) const;
  bool at_wall(HalfEdge h) const;
  bool at_corner(HalfEdge first) const;
  template <class Holds>
  bool any(HalfEdge first, const Holds& holds) const;
  double across(HalfEdge h) const;
  struct Fan {
    int bends = 0;
    double most = 1, lean = 1;
  };
  Fan measure(HalfEdge first) const;

  const ProxyMesh& proxy_;
  const std::vector<Vec3>& normals_;
  double crease_angle_;
};

}  // namespace burin
