#pragma once
// What operands of a clipping knew, given back to its result; for converters/openscad alone.

#include <burin/base/vec.h>

#include "solid.h"

#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace burin::csg {

/// A place on the grid.
struct GridPoint {
  std::int64_t x = 0, y = 0;
  bool operator==(const GridPoint&) const = default;
};
struct GridPointHash {
  std::size_t operator()(const GridPoint& p) const;
};
/// Towards zero, as OpenSCAD does. Throws InputError where `p` is no number or beyond 1e12 mm.
GridPoint on_grid(Vec2 p);
Vec2 off_grid(GridPoint p);

/// Points by their place on the grid, and edges that stand for arcs.
class Origins {
 public:
  void add(const Region& region);
  void add_point(Vec2 p) { points_.emplace(on_grid(p), p); }
  void add_edge(Vec2 a, Vec2 b, const Arc& arc);

  /// The point that was added at this place, else the place itself.
  Vec2 point(GridPoint p) const;
  /// Gives each edge that lies on one that was added its arc.
  void tag(Region& result) const;

 private:
  struct Edge {
    Vec2 a, b;
    std::uint32_t arc;
  };
  struct Cell {
    int level;
    std::int64_t x, y;
    bool operator==(const Cell&) const = default;
  };
  struct CellHash {
    std::size_t operator()(const Cell& c) const;
  };
  std::int64_t arc_on(Vec2 a, Vec2 b) const;

  std::unordered_map<GridPoint, Vec2, GridPointHash> points_;
  std::vector<Arc> arcs_;
  std::vector<Edge> edges_;
  /// Edges by their length (the power of two above it) and by the squares of that size around them.
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells_;
  std::map<int, double> levels_;
};

/// Arcs that no edge uses go, equal ones become one.
void tidy_arcs(Region& region);

/// An outline the other way round; each edge keeps its arc.
Outline reversed(const Outline& outline);
/// Twice the area, positive where counter-clockwise.
double doubled_area(const Outline& outline);
double area(const Region& region);

}  // namespace burin::csg
