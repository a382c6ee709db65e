#pragma once
/// Triangles without what lies beyond all of several planes; internal to the module.

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/section/section.h>

#include "cut_piece.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

namespace burin::detail {

/// A triangle with what is known of it.
struct CutTriangle {
  Triangle corners;
  FacetPiece piece;
};

/// Divides triangles plane by plane. The BODY is what lies beyond all planes so far, closed where
/// they run through it by WALLS, so that each plane finds loops; what lies before a plane is kept.
/// In the end the body goes, and its walls, turned over, close what is kept.
class Cutter {
 public:
  /// A place of the exact surface and its normal.
  struct Lifted {
    Vec3 position{0}, normal{0};
  };
  /// That over a place of a facet.
  using Lift = std::function<Lifted(std::uint32_t facet, Vec3 bary)>;

  /// With `lift`, points between two vertices are where the plane meets the exact surface.
  Cutter(const TriMesh& mesh, Lift lift, const RunContext& context);

  /// The last plane of a region: nothing is cut afterwards.
  void cut(const CutPlane& plane, std::int32_t number, bool last);
  /// No part of any triangle goes.
  bool whole() const { return whole_; }
  /// No triangle stays.
  bool gone() const { return kept_.empty(); }
  /// Some loops did not close; there are no walls there.
  bool open() const { return open_; }
  /// What is left, those of a facet one after the other, and what closes it; once.
  std::vector<CutTriangle> result();

  std::vector<Vec3> positions;  // of the mesh, and the cut points

 private:
  /// A point between two vertices, by its share of the way from the lower number, and the place of
  /// the facet that it was found by on the exact surface; no normal: it has none.
  struct Between {
    std::uint32_t vertex = 0;
    double share = 0;
    Lifted lifted = {};
  };
  struct Corner {
    std::uint32_t vertex;
    Vec3 bary;
  };
  class Polygon;

  void measure(const CutPlane& plane);
  bool beyond(std::uint32_t vertex) const { return height_[vertex] >= -on_plane_; }
  bool lies_on_plane(std::uint32_t vertex) const;
  bool lies_in_plane(const CutTriangle& t) const;
  void divide(const CutTriangle& t, std::vector<CutTriangle>* near, std::vector<CutTriangle>* far);
  Corner between(const CutTriangle& t, std::size_t k, std::size_t j);
  Vec3 find_between(const CutTriangle& t, std::size_t low, std::size_t high, Between& out) const;
  bool is_on_surface(const CutTriangle& t) const;
  void move_onto_edge(const CutTriangle& t, Vec3 bary, const Between& at);
  void add_polygon(Polygon polygon, const FacetPiece& piece, std::vector<CutTriangle>& out) const;
  bool close(const CutPlane& plane, std::int32_t number, std::span<const CutTriangle> near,
             std::span<const CutTriangle> sheets, std::vector<CutTriangle>& walls);
  void divide_kept_edges();
  void stand_beside(std::span<const CutTriangle> kept, std::vector<CutTriangle>& caps);

  Lift lift_;
  const RunContext& context_;
  CutPlane plane_;  // that cuts now
  double on_plane_ = 0;
  bool whole_ = false, open_ = false;
  std::vector<CutTriangle> body_, kept_;
  /// Faces in a plane, seen from beyond it: nothing lies behind them there, they are cut areas as
  /// far as they lie beyond the planes that follow.
  std::vector<CutTriangle> sheets_;
  // Of the plane that cuts now.
  std::vector<double> height_;  // mm beyond it
  std::unordered_map<std::uint64_t, Between> points_;
  std::vector<std::uint8_t> on_some_plane_;  // of vertices: one that was cut by before
};

}  // namespace burin::detail
