#pragma once
// A smooth surface through a grid of points; internal to the module.

#include <burin/base/box.h>
#include <burin/forms/charted/chart.h>
#include <burin/forms/recognised/point_grid.h>

#include <array>
#include <cstdint>
#include <vector>

namespace burin::recognised {

/// Weights of four nodes that follow one another, for a value and two derivatives.
struct NodeWeights {
  std::array<std::int32_t, 4> node{};
  std::array<double, 4> value{}, first{}, second{};
};

/// Cubics between nodes with one tangent at each, that of the parabola through the node and its
/// neighbours; a span that is much longer than its neighbour is a line.
class SplineAxis {
 public:
  SplineAxis(std::vector<double> knots, std::int32_t nodes, bool closes);

  /// The weights at a parameter, `span` being where it lies.
  NodeWeights weights(std::int32_t span, double t) const;
  std::int32_t span_at(double t) const;
  std::int32_t spans() const { return static_cast<std::int32_t>(knots_.size()) - 1; }
  double knot(std::int32_t i) const { return knots_[static_cast<std::size_t>(i)]; }
  double period() const { return closes_ ? knots_.back() - knots_.front() : 0; }
  /// The nearest parameter in `count` spans from `first` on; at ends where nothing follows, half a
  /// span beyond them.
  double kept(double t, std::int32_t first, std::int32_t count) const;

 private:
  /// The derivative at a node by three nodes from `first` on.
  struct Tangent {
    std::int32_t first = 0;
    std::array<double, 3> weight{};
  };
  Tangent tangent_at(std::int32_t node) const;
  Tangent inner_tangent(std::int32_t node) const;
  double length(std::int32_t span) const;

  std::vector<double> knots_;
  std::int32_t nodes_;
  bool closes_;
  std::vector<Tangent> tangents_;
};

/// S(u,v) through the points of a grid: u along a row, v from row to row, once continuously
/// differentiable. Immutable.
class Sheet {
 public:
  explicit Sheet(PointGrid grid);

  SurfaceDerivatives derivatives(Vec2 uv) const;
  /// The parameters of the nearest point of some cells, by Newton's method from the nearest facet
  /// on. Cost: 2 us.
  Vec2 locate(Vec3 p, const GridWindow& window) const;
  /// Whether another grid has the same points.
  bool goes_through(const PointGrid& grid) const;
  Vec2 period() const { return {u_.period(), v_.period()}; }
  /// Size of the box of the points in mm.
  double size() const { return size_; }
  /// The largest distance in mm between the facets of a cell and the surface, and the largest angle
  /// between facets of neighbouring cells.
  double sagitta() const { return sagitta_; }
  double turn() const { return turn_; }

 private:
  struct Block {
    Box3 box;
    GridWindow cells;
    std::int32_t low = -1, high = -1;
  };
  struct Found {
    double square = 1e300;
    std::int32_t row = 0, column = 0;
    /// Within the cell.
    Vec2 share{0};
  };

  SurfaceDerivatives at(std::int32_t column, std::int32_t row, Vec2 uv) const;
  std::int32_t build(Block block);
  void measure();
  /// Among the cells of a block, whose box lies `square` mm2 from p.
  void search(std::int32_t block, double square, Vec3 p, const GridWindow& window,
              Found& found) const;
  Found on_cell(std::int32_t row, std::int32_t column, Vec3 p) const;
  /// From the nearest cell on to the foot of the perpendicular.
  Vec2 foot(Vec3 p, Vec2 uv, const GridWindow& window) const;

  PointGrid grid_;
  SplineAxis u_, v_;
  std::vector<Block> blocks_;
  double size_ = 0, sagitta_ = 0, turn_ = 0;
};

}  // namespace burin::recognised
