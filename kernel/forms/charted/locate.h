#pragma once
// The triangles of a charted surface as they lie in (u,v): which one holds a point, what is beyond
// its sides, and how far the true edge curves are from the sides that stand for them.

#include <burin/forms/charted/atlas.h>
#include <burin/mesh/topology.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace burin::detail {

/// Where a straight segment of (u,v) leaves a triangle.
struct UvExit {
  HalfEdge edge = kNoHalfEdge;  // none: the segment ends inside
  double share = 1;             // of the segment; below 0 where it begins beyond the side
};

/// A place on the true curve of a border half-edge.
struct BorderPlace {
  double share = 0;  // along the chord, in [0,1]
  double t = 0;      // the edge's parameter
  Vec2 uv{0};        // on the curve, in the branch of the half-edge's triangle
};

/// A place of a triangle drawn from two random numbers; one in `keep` of them makes it uniform in
/// (u,v).
struct UvDraw {
  Vec3 bary{1, 0, 0};
  double keep = 1;
};

/// Tells a walk from triangle to triangle that goes round for ever, as one over a broken
/// tessellation may: it comes again to a triangle in the same branch. @cite Brent1980
class WalkGuard {
 public:
  /// False where the walk stands where it stood before, or has passed too many triangles.
  bool go_on(std::uint32_t triangle, Vec2 step) {
    if (triangle == triangle_ && step == step_) return false;
    if (++count_ == next_) {
      triangle_ = triangle;
      step_ = step;
      next_ *= 2;
    }
    return count_ < kMost;
  }

 private:
  // Triangles of one walk: more than lie along any line over a part on a sheet.
  static constexpr int kMost = 100'000;
  std::uint32_t triangle_ = ~std::uint32_t{0};
  Vec2 step_{0};
  int count_ = 0, next_ = 64;
};

/// A triangle with a corner at a pole stands for a strip of (u,v) up to the whole collapsed side:
/// its two sides through the pole run along the parameter that is not collapsed, so that the strips
/// of the fan leave no gaps.
class UvTriangles {
 public:
  /// `opposite` as in Topology; all must outlive this.
  UvTriangles(const PlacedAtlas& atlas, const ChartMesh& mesh,
              const std::vector<HalfEdge>& opposite, const RunContext& context);

  std::int32_t face(std::uint32_t triangle) const { return mesh_.face[triangle]; }
  Vec2 uv(std::uint32_t triangle, Vec3 bary) const;
  /// Not clamped.
  Vec3 bary(std::uint32_t triangle, Vec2 uv) const;
  /// A place from two uniform numbers, and the area of (u,v) that it is drawn from: that of the
  /// triangle, or a rectangle around its strip, of which `keep` leaves the strip.
  UvDraw draw(std::uint32_t triangle, double a, double b) const;
  double draw_area(std::uint32_t triangle) const;
  /// The triangle of the same face at a point, walking from `triangle`; at borders the last one
  /// before them. Takes `target` to the branch of that triangle.
  std::uint32_t locate(std::uint32_t triangle, Vec2& target) const;

  UvExit exit(std::uint32_t triangle, Vec2 from, Vec2 to) const;
  bool is_border(HalfEdge h) const { return mesh_.border[static_cast<std::size_t>(h)] >= 0; }
  HalfEdge opposite(HalfEdge h) const { return opposite_[static_cast<std::size_t>(h)]; }
  /// What to add to (u,v) of the triangle of `h` in that of its opposite: whole periods.
  Vec2 branch_step(HalfEdge h) const;
  /// The next border half-edge of the face after the target of `h`, or before its origin; adds
  /// periods to `step` as branch_step does.
  HalfEdge next_border(HalfEdge h, Vec2& step) const;
  HalfEdge previous_border(HalfEdge h, Vec2& step) const;

  /// The place on the true curve of a border half-edge beside a point.
  BorderPlace beside(HalfEdge h, Vec2 uv) const;
  /// Distance in (u,v) of a point inwards from the true curve.
  double inside(HalfEdge h, Vec2 uv) const {
    const double distance = inside_chord(h, uv);
    return bulge(h) == 0 ? distance : distance - inside_chord(h, beside(h, uv).uv);
  }
  /// The same distance from the chord alone.
  double inside_chord(HalfEdge h, Vec2 uv) const;
  /// Where a point lies along the chord: 0 at its origin, 1 at its target.
  double share(HalfEdge h, Vec2 uv) const;
  /// A bound of how far the curve is from the chord, 0 where it is straight.
  double bulge(HalfEdge h) const {
    return bulge_[static_cast<std::size_t>(mesh_.border[static_cast<std::size_t>(h)])];
  }
  /// Whether a side of the triangle is a curved border.
  bool curved(std::uint32_t triangle) const { return curved_[triangle] != 0; }
  /// Distances below this are none: a share of the triangle's height over the border half-edge.
  double noise(HalfEdge h) const;
  BorderPlace place(HalfEdge h, double t) const;
  /// The same by the share of the parameter.
  BorderPlace place_at(HalfEdge h, double share) const {
    const ChartMesh::Border& b = border(h);
    return place(h, b.t0 + share * (b.t1 - b.t0));
  }
  /// The place on the opposite side of a border half-edge that is the same point in space.
  BorderPlace across(HalfEdge h, const BorderPlace& from) const;
  /// The derivative of the curve at a place by the share of the chord.
  Vec2 tangent(HalfEdge h, const BorderPlace& at) const;
  /// +1 where triangles of a face run counter-clockwise in (u,v), else -1.
  double turn(std::uint32_t triangle) const {
    return turn_[static_cast<std::size_t>(face(triangle))];
  }
  /// How far, in multiples of `velocity`, the domain of the face reaches; infinite where it is
  /// periodic.
  double to_side(std::uint32_t triangle, Vec2 uv, Vec2 velocity) const;
  ModelEdgeClass edge_class(HalfEdge h) const {
    return mesh_.border_class(static_cast<std::size_t>(h));
  }
  /// Whether a point lies at or beyond the collapsed side of a triangle at a pole; then the share
  /// of the way from `from` to `to` at which the side is met.
  bool meets_pole(std::uint32_t triangle, Vec2 from, Vec2 to, double& share) const;

 private:
  struct Side {
    Vec2 a, b;
  };
  Side side(HalfEdge h) const;
  /// The strip of a triangle at a pole: its width, and its signed heights on both sides.
  struct Strip {
    double width = 0, first = 0, second = 0;
    double tallest() const { return std::max(std::abs(first), std::abs(second)); }
  };
  Strip strip(std::uint32_t triangle) const;
  Vec2 corner(HalfEdge h) const { return mesh_.uv[static_cast<std::size_t>(h)]; }
  const ChartMesh::Border& border(HalfEdge h) const {
    return mesh_.borders[static_cast<std::size_t>(mesh_.border[static_cast<std::size_t>(h)])];
  }
  /// Whether a triangle has no area in (u,v) but for rounding, which then decides where a point of
  /// it seems to lie, and the point is on it.
  bool lies_on_flat(std::uint32_t triangle, Vec2 p) const;
  Vec2 to_branch(std::uint32_t triangle, Vec2 uv, Vec2 near) const;
  void find_poles();
  void find_bulges(const RunContext& context);

  const PlacedAtlas& atlas_;
  const ChartMesh& mesh_;
  const std::vector<HalfEdge>& opposite_;
  std::vector<double> turn_;        // a face
  std::vector<Vec2> period_;        // a face
  std::vector<ParameterBox> box_;   // a face; infinite where periodic
  std::vector<std::uint8_t> pole_;  // a triangle: 0, or 1 + corner + 4 * collapsed direction
  std::vector<std::uint8_t> curved_;
  std::vector<double> bulge_;  // a border
};

}  // namespace burin::detail
