#pragma once
// A chart mesh under the knife: what its corners see, its edges as curves on the surface, and the
// operations that split it.

#include <burin/camera/camera.h>
#include <burin/camera/facing.h>
#include <burin/contour_cut/sampler.h>
#include <burin/work_mesh/chart_mesh.h>

#include <array>
#include <cstdint>
#include <vector>

namespace burin {

/// A place in a face: g by the normal of that face alone, and how g changes.
struct FaceSample {
  Vec2 uv{0};
  Vec3 position{0}, normal{0};
  double g = 0;
  /// The derivatives of g in (u,v).
  Vec2 gradient{0};
  /// The step in (u,v) to where g is zero, to first order, and its length in model mm (infinite
  /// where g does not change to first order).
  Vec2 to_zero{0};
  double distance = 0;
  /// Along the level of g; zero where that is not known.
  Vec3 along{0};
};

/// A place on an edge. Side 0 is that of the half-edge, 1 that of its opposite.
struct EdgePoint {
  double share = 0;
  Vec3 position{0};
  std::array<Vec2, 2> uv{};
  /// Of the wedges there: on edges that are not sharp the same for both sides.
  std::array<Vec3, 2> normal{};
  /// g by those, and by the normal of the side's own face.
  std::array<double, 2> g{}, own_g{};
  /// Whether g is taken to be zero.
  std::array<bool, 2> zero{};
};

class CutMesh {
 public:
  CutMesh(ChartMesh& mesh, const Sampler& surface, const Camera& camera, const RunContext& context);

  const ChartMesh& mesh() const { return mesh_; }
  const Camera& camera() const { return camera_; }
  std::size_t half_edge_count() const { return g_.size(); }
  HalfEdge opposite(HalfEdge h) const { return opposite_[at(h)]; }
  bool sharp(HalfEdge h) const;
  std::int32_t face(HalfEdge h) const { return mesh_.face[face_of(h)]; }
  FaceKind kind(HalfEdge h) const { return kinds_[static_cast<std::size_t>(face(h))]; }
  std::uint32_t vertex(HalfEdge h) const { return mesh_.triangles[face_of(h)][at(h) % 3]; }
  const Vec3& position(HalfEdge corner) const { return mesh_.positions[vertex(corner)]; }
  const Vec3& normal(HalfEdge corner) const { return mesh_.normal[at(corner)]; }
  Vec2 uv(HalfEdge corner) const { return mesh_.uv[at(corner)]; }
  double g(HalfEdge corner) const { return g_[at(corner)]; }
  int sign(HalfEdge corner) const { return (g(corner) > 0) - (g(corner) < 0); }
  bool pole(HalfEdge corner) const { return pole_[at(corner)] != 0; }
  /// Paper mm of a length at a place, not foreshortened.
  double on_paper(Vec3 p, double length) const { return length * camera_.scale_at(p); }

  /// How far g at a corner, by its wedge's normal (or because it is taken to be zero), is from g by
  /// the normal of the corner's face: what has to be added, spread linearly, to make g of the face
  /// agree with its corners.
  double shift(HalfEdge corner) const;
  FaceSample sample(std::int32_t face, Vec2 uv) const;
  /// (u,v) on the edge of `h` in its triangle, and the place there.
  Vec2 uv_on(HalfEdge h, double share) const;
  EdgePoint edge_point(HalfEdge h, double share) const;

  /// Counts the changes of a triangle.
  std::uint32_t version(std::uint32_t face) const { return version_[face]; }

  /// Splits both triangles at the edge of `h`; from the new vertex on the edge of `h` runs to its
  /// old target. Returns the half-edge from the new vertex to that target.
  HalfEdge split_edge(HalfEdge h, const EdgePoint& point);
  /// Splits a triangle in three; `shift` as above, at the new vertex.
  void split_face(std::uint32_t face, const FaceSample& sample, double shift);
  /// Takes g to be zero at the wedge of a corner. A vertex inside a face is moved to `zero` (a
  /// place in the triangle of the corner).
  void mark_zero(HalfEdge corner, const FaceSample* zero);
  /// The corners of the wedge of a corner.
  std::vector<HalfEdge> wedge(HalfEdge corner) const;

  /// Half-edges move when triangles are split: keeps `edges` up to date while it is watched.
  void watch(std::vector<HalfEdge>& edges);
  void unwatch();

  /// What is still to be done at edges; requests move with their edges.
  enum Request : std::uint8_t { Cut = 1, Look = 2 };
  void request(HalfEdge h, Request what);
  bool any_request(Request what) const { return !requested_[what - 1].empty(); }
  /// The edges that `what` was requested for, each once and by its lower half-edge, ascending; the
  /// requests are forgotten.
  std::vector<HalfEdge> take_requests(Request what);

 private:
  static std::size_t at(HalfEdge h) { return static_cast<std::size_t>(h); }

  Vec3 border_normal(HalfEdge h, double share, const std::array<Vec3, 2>& faces) const;
  void find_poles();
  void mark_poles(const std::vector<std::uint8_t>& suspects);
  bool may_move(const std::vector<HalfEdge>& wedge, Vec2 by) const;
  std::uint32_t add_triangle(std::uint32_t like);
  void set_corner(HalfEdge corner, std::uint32_t vertex, const EdgePoint& point, std::size_t side);
  void copy_corner(HalfEdge from, HalfEdge to);
  void move_edge(HalfEdge from, HalfEdge to);
  void link(HalfEdge a, HalfEdge b);
  HalfEdge split_side(HalfEdge h, std::uint32_t vertex, const EdgePoint& point, std::size_t side,
                      double edge_parameter);

  ChartMesh& mesh_;
  const Sampler& surface_;
  const Camera& camera_;
  FacingFunction facing_;
  std::vector<HalfEdge> opposite_;
  /// A face.
  std::vector<FaceKind> kinds_;
  /// A corner.
  std::vector<double> g_;
  /// A corner: what `shift` gives; NaN where it is found when it is asked for.
  std::vector<double> shift_;
  /// A corner: 1 where every u, 2 where every v is the same point.
  std::vector<std::uint8_t> pole_;
  std::vector<std::uint32_t> version_;
  std::vector<HalfEdge>* watched_ = nullptr;
  std::vector<std::int32_t> watch_;
  /// A half-edge: the requests of its edge; and all half-edges with one, among others.
  std::vector<std::uint8_t> requests_;
  std::array<std::vector<HalfEdge>, 2> requested_;
};

}  // namespace burin
