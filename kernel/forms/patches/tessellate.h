#pragma once
// Triangles over untrimmed patches.

#include <burin/forms/charted/raw_mesh.h>

#include "weld.h"

namespace burin::detail {

/// Lines of the grid over a face: ascending parameters in u and in v, the domain's ends and all
/// lines included at which S has no first derivative (knots of full multiplicity): over one of them
/// the error of a chord does not fall with the square of its length.
struct FaceGrid {
  std::array<std::vector<double>, 2> lines;
};

/// How many grid lines a chart asks for: its second derivatives bound how far the triangles are
/// from S, the turning of its normal the angle between neighbours. A grid that its worst spots
/// would make much finer than all places together need stays coarser there, for `refine` to split.
class GridPlan {
 public:
  explicit GridPlan(const Chart& chart);
  /// Lines for a largest distance in model mm from S, and kAlong times as much from the point of S
  /// at the same (u,v), or a `share` as dense; `least` cells a direction.
  FaceGrid lines(double distance, double share, std::array<int, 2> least) const;

 private:
  /// Second derivatives of the distance from the triangles: along u, along v and mixed.
  struct Bend {
    double u = 0, v = 0, mixed = 0;
  };
  /// What lies between two break lines of a direction, or between one and an end of the domain.
  struct Piece {
    double from = 0, to = 0;
    std::size_t first = 0, count = 0;  // samples, at both ends and evenly between them
    double step() const { return (to - from) / static_cast<double>(count - 1); }
  };
  using Density = std::array<std::vector<double>, 2>;

  void find_pieces(const Chart& chart);
  void sample(const Chart& chart);
  /// Cells a unit of the parameter at each sample of a direction.
  std::vector<double> density(int direction, double distance) const;
  Density densities(double distance, double share) const;
  double largest_distance(const Density& density) const;
  double cells(const Piece& piece, const std::vector<double>& density) const;
  double all_cells(const Density& density) const;
  double needed_cells(double distance) const;
  std::vector<double> places(const Piece& piece, const std::vector<double>& density,
                             int cells) const;

  ParameterBox box_;
  std::vector<Piece> pieces_[2];
  /// A sample of a direction: its parameter, where derivatives are taken, and the width in
  /// parameters that it stands for.
  std::vector<double> at_[2], inside_[2], width_[2];
  std::vector<Bend> normal_, full_;  // a sample; sample (i, j) is i * (samples in v) + j
  std::vector<Vec2> normal_turn_;    // the same: radians a unit of the parameters
  /// For each direction at its samples, the largest along the other one: the bend, and the angle
  /// that the normal turns through a unit of the parameter.
  std::vector<double> bend_[2], turn_[2];
  double length_[2] = {0, 0};  // model mm along the longest lines
};

/// A point of a triangle may lie this many times farther from the point of S at the same (u,v) than
/// from S: along the surface nothing is seen of it.
inline constexpr double kAlong = 2;

/// A vertex on a side of a face, in the side's own order.
struct SideNode {
  std::uint32_t vertex = 0;
  double side_t = 0, edge_t = 0;
};

/// Adds the triangles of one face: a grid inside, and strips between it and the nodes of the sides
/// (a single one where a side is a pole).
void add_face(RawMesh& raw, const PatchComplex& complex, std::int32_t face, const FaceGrid& grid,
              const std::array<std::vector<SideNode>, 4>& sides);

/// Triangles within `tolerance` model mm of S; states the largest distance that it measured from S
/// at the same (u,v). Both faces of an edge use its nodes. Normals are not filled. `complete` is
/// false where `triangle_bound` did not let it come so near.
struct Tessellation {
  ChartMesh mesh;
  bool complete = true;
};
Tessellation tessellate(const PatchComplex& complex, double tolerance, const RunContext& context);

}  // namespace burin::detail
