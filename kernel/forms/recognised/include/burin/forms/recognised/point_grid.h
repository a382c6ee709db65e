#pragma once
/// Rows of points on a surface, as those who sweep or extrude an outline make them.

#include <burin/base/vec.h>

#include <cstdint>
#include <vector>

namespace burin {

/// Cells of a grid: `rows` from `row` on, and so of columns; all where there are none.
struct GridWindow {
  std::int32_t row = 0, rows = 0, column = 0, columns = 0;
  bool operator==(const GridWindow&) const = default;
  bool overlaps(const GridWindow& w) const {
    return rows == 0 || (row < w.row + w.rows && w.row < row + rows &&
                         column < w.column + w.columns && w.column < column + columns);
  }
};

/// Points of a surface, row by row, `columns` a row. Neighbours of two rows are the corners of a
/// cell.
struct PointGrid {
  std::int32_t rows = 0, columns = 0;
  /// Whether the last row (column) goes over into the first.
  bool rows_close = false, columns_close = false;
  /// In mm.
  std::vector<Vec3> points;
  /// Ascending, one a row (column), and one more where they close: the parameters there. Grids that
  /// share a border and its knots have the same curve there.
  std::vector<double> row_knots, column_knots;
  /// The part that is meant. A surface that comes back to where it began and meets itself there in
  /// an edge is told as two, so that a point of that edge is one place of each.
  GridWindow window;

  std::int32_t cell_rows() const { return rows_close ? rows : rows - 1; }
  std::int32_t cell_columns() const { return columns_close ? columns : columns - 1; }
  Vec3 point(std::int32_t row, std::int32_t column) const {
    return points[static_cast<std::size_t>(row % rows * columns + column % columns)];
  }
};

/// What is known of the rows of a grid.
enum class Rows : std::uint8_t {
  /// They are smooth where their angles say so, as columns are.
  Judged,
  /// Steps of something that turns or grows: smooth unless they turn by more than facets may.
  Steps,
};

struct SmoothGrids {
  std::vector<PointGrid> pieces;
  /// For each cell, row by row, its piece, or -1: it lies in a plane or in a surface that facets
  /// are recognised as, a cylinder or one of revolution.
  std::vector<std::int32_t> piece_of;
};

/// The smooth pieces of a grid: it is parted at the rows and columns along which cells meet in an
/// edge. Edges are smooth where at least four cells follow one another at angles of which none is
/// much larger than its neighbours', up to 15 degrees, or at equal angles up to 40 degrees. Knots
/// are set to the mean distances of rows and columns. Cost: linear in the number of points.
SmoothGrids smooth_grids(PointGrid grid, Rows rows);

}  // namespace burin
