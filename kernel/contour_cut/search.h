#pragma once
// Where a chart mesh has to be split for a view.

#include <burin/contour_cut/contour_cut.h>

#include "cut_mesh.h"

#include <optional>

namespace burin {

/// Radians: smaller values of g are noise of charts with numeric derivatives.
inline constexpr double kNumericNoise = 1e-8;

/// What is to be done at an edge or in a triangle.
struct Incision {
  enum class What {
    Nothing,
    SplitEdge,
    MarkOrigin,  // the contour passes through an end of the half-edge
    MarkTarget,
    Detour,  // split the edge, the new vertex at `place`, in the triangle of side `side`
    SplitFace,
  };
  What what = What::Nothing;
  HalfEdge half_edge = kNoHalfEdge;
  EdgePoint point;
  FaceSample place;
  std::size_t side = 0;
  std::uint32_t face = 0;
  double shift = 0;  // of g at `place`, for SplitFace
};

/// Reads the mesh only; may be called from many threads.
class CutSearch {
 public:
  CutSearch(const CutMesh& mesh, const ContourCutOptions& options)
      : mesh_(mesh), options_(options) {}

  /// Whether g changes its sign along `h` on either side of the edge.
  bool crosses(HalfEdge h) const { return crosses_in(h) || crosses_in(mesh_.opposite(h)); }
  /// The zero on an edge that crosses.
  Incision zero(HalfEdge h) const;

  /// Whether both ends are zeros for both sides and the surface goes on smoothly.
  bool chord(HalfEdge h) const;
  /// Whether the contour is too far from a chord of it, or what looks like one is none.
  Incision bulge(HalfEdge h) const;

  /// Whether g may have zeros between the ends of an edge although their signs agree.
  bool suspect(HalfEdge h) const { return suspect_in(h) || suspect_in(mesh_.opposite(h)); }
  Incision hidden_crossing(HalfEdge h) const;

  /// The same inside a triangle.
  bool suspect_face(std::uint32_t face) const;
  Incision hidden_loop(std::uint32_t face) const;

 private:
  bool crosses_in(HalfEdge h) const {
    return h != kNoHalfEdge && mesh_.sign(h) * mesh_.sign(next_in_face(h)) < 0;
  }
  /// Where a line leaves a triangle: on which edge, and its share from that half-edge's origin.
  struct Exit {
    HalfEdge half_edge = kNoHalfEdge;
    double share = 0;
    Vec2 uv{0};
  };
  /// A place in a face where g is known, and what it is more than g of the face.
  struct Known {
    Vec2 uv{0};
    double g = 0, shift = 0;
  };
  bool suspect_in(HalfEdge h) const;
  bool within_reach(HalfEdge a, HalfEdge b, double lowest, double length) const;
  int side_sign(HalfEdge h) const;
  double edge_length(HalfEdge h) const;
  Vec2 uv_at(std::uint32_t face, Vec3 bary) const;
  double shift_at(std::uint32_t face, Vec3 bary) const;
  EdgePoint point_on(HalfEdge h, double share) const;
  bool deep(const FaceSample& s, double g) const;
  Incision dip_in(HalfEdge h, int side) const;
  Incision false_chord(HalfEdge h, int left, int right) const;
  Incision true_chord(HalfEdge h, int left) const;
  std::optional<Exit> across(HalfEdge h, Vec2 from, Vec2 way) const;
  Incision split_at_exit(const Exit& exit, double g) const;
  FaceSample zero_between(std::int32_t face, const Known& from, const Known& to) const;
  Incision all_zero(HalfEdge h) const;

  const CutMesh& mesh_;
  ContourCutOptions options_;
};

}  // namespace burin
