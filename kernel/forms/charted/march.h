#pragma once
// One walk along a geodesic over faces, triangles and edges.

#include <burin/surface/surface.h>

#include "locate.h"
#include "march_path.h"

#include <optional>

namespace burin::detail {

/// Border half-edges looked at round a vertex to find the one that a way leaves through.
constexpr int kMaxHandOvers = 8;
/// Steps of Newton's method that make the place of a crossing exact.
constexpr int kMaxRefinements = 3;

/// Created for one call of Surface::march; nothing in it allocates.
class March {
 public:
  March(const PlacedAtlas& atlas, const UvTriangles& triangles, const BreakLines& lines,
        double length)
      : atlas_(atlas), triangles_(triangles), lines_(lines), length_(length) {}

  MarchStep run(const SurfacePoint& from, Vec3 tangent);

 private:
  /// Where a step leaves the face: the border half-edge, and a share of the straight way from its
  /// begin to its end that is surely beyond it.
  struct Crossing {
    HalfEdge edge = kNoHalfEdge;
    double upto = 1;
  };
  /// A step's straight way in the branch of the triangle that it has come to.
  struct Way {
    Vec2 from, to, step{0};
    std::uint32_t triangle;
    void move(Vec2 by) {
      from += by;
      to += by;
      step += by;
    }
    Vec2 at(double share) const { return from + share * (to - from); }
  };

  bool start(Vec2 uv, Vec3 tangent);
  std::optional<MarchStop> enter_cell();
  void stop_at_line(PathState& to, double& length) const;
  std::optional<MarchStop> advance(PathState& to, double length);
  Crossing pass(PathState& to);
  Crossing leave(HalfEdge h, Way& way) const;
  HalfEdge beyond(Way& way) const;
  bool passes_curve(const Way& way, const UvExit& exit, Crossing& crossing) const;
  double meet(const Crossing& crossing, const PathState& to, double length) const;
  double refine(const Crossing& crossing, double length, double guess, PathState& at) const;
  double find_crossing(Crossing& crossing, PathState& to, double length, PathState& at);
  std::optional<MarchStop> cross(Crossing crossing, PathState& to, double length);
  std::optional<MarchStop> enter(HalfEdge h, const BorderPlace& place, bool progress);
  std::optional<MarchStop> slide(HalfEdge h, const BorderPlace& place, Vec3 direction);
  GeodesicPath path() const { return {atlas_, triangles_.face(triangle_), inner_}; }
  MarchStep result(MarchStop stop) const;

  const PlacedAtlas& atlas_;
  const UvTriangles& triangles_;
  const BreakLines& lines_;
  double length_;
  double gone_ = 0;
  std::uint32_t triangle_ = 0;
  PathState state_;
  // Between the break lines of the face that the march is in, and by rounding less: derivatives on
  // a line belong to the cell above it.
  ParameterBox cell_ = kUnbounded, inner_ = kUnbounded;
  int turns_ = 0;      // crossings without progress in a row
  bool lost_ = false;  // the triangles under the way lead round for ever
  double slide_ = 0;   // model mm of the last slide along an edge
};

}  // namespace burin::detail
