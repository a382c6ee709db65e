#pragma once
// How large triangles may be, place by place.

#include "crease_chains.h"

#include <span>
#include <unordered_map>

namespace burin {

/// The radius of the ball through a triangle's corners for which its sagitta is the tolerance:
/// sqrt(2 r tolerance), r the local radius of curvature; smaller in thin walls, and growing by a
/// quarter of the distance from there. Known at the vertices of a coarse mesh, and by cells
/// between.
class Sizing {
 public:
  Sizing(const ExactMesh& mesh, const ImplicitFunction& f, const CreaseChains& chains,
         double tolerance, const RunContext& context);

  /// Model mm.
  double at(Vec3 p) const;
  double at_vertex(std::uint32_t v) const { return radius_[v]; }
  /// The vertices that share an edge with v; none where v is in no triangle.
  const std::vector<std::uint32_t>& around(std::uint32_t v) const { return next_[v]; }
  double tolerance() const { return tolerance_; }
  double least() const { return least_; }
  /// Vertices that triangles of these sizes need, about.
  double expected_vertices() const { return expected_; }
  /// Makes all triangles `times` as large.
  void enlarge(double times);
  /// Whether curvature may be stronger at p than the coarse mesh tells.
  bool doubtful(Vec3 p) const { return at(p) < doubtful_; }

 private:
  void by_curvature(const ImplicitFunction& f, const CreaseChains& chains,
                    const RunContext& context);
  void by_thickness(const ImplicitFunction& f, const RunContext& context);
  /// Along the edges to the nearest crease.
  std::vector<double> crease_distances() const;
  /// No value above that of a neighbour by more than `growth` times the distance.
  void spread(std::vector<double>& values, double growth) const;
  void fill_cells();

  const ExactMesh& mesh_;
  double tolerance_, largest_, least_ = 0, expected_ = 0, doubtful_ = 0;
  Vec3 origin_{0};
  std::vector<double> radius_;
  std::vector<std::vector<std::uint32_t>> next_;  // vertices around a vertex
  std::unordered_map<std::uint64_t, double> cells_;
};

}  // namespace burin
