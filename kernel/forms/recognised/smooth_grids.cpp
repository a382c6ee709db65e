#include <burin/base/box.h>
#include <burin/forms/recognised/point_grid.h>

#include "facets.h"
#include "profiles.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace burin {
namespace {

using recognised::at;
using recognised::kDegree;
using recognised::kEqual;
using recognised::kOtherCircle;

// Steps of a turn of more than this are facets.
constexpr double kLargestStepOfGrid = 40.5 * kDegree;
// Turns of an ellipse's sides follow one another as unequal as this.
constexpr double kUnequal = 0.45;
// Of the size: within that, points lie in a plane or on a line.
constexpr double kFlatGrid = 1e-7;
// Of the size: what six digits leave of points that are one.
constexpr double kSamePoint = 5e-6;
// Sides from which on equal lengths and angles are those of a circle.
constexpr std::size_t kFewestSides = 3;

/// Cells from `first` on, `count` of them; all of what closes where `whole`.
struct Run {
  std::int32_t first = 0, count = 0;
  bool whole = false;
};

/// The runs between joints that are not smooth. Joint k lies after cell k.
std::vector<Run> runs_between(const std::vector<bool>& smooth, std::int32_t cells, bool closes) {
  const auto edge = std::find(smooth.begin(), smooth.end(), false);
  if (closes && edge == smooth.end()) return {{0, cells, true}};
  std::vector<Run> runs;
  const std::int32_t start =
      closes ? static_cast<std::int32_t>(edge - smooth.begin() + 1) % cells : 0;
  for (std::int32_t i = 0; i < cells;) {
    Run run{(start + i) % cells, 1};
    while (i + run.count < cells && smooth[at((start + i + run.count - 1) % cells)]) ++run.count;
    runs.push_back(run);
    i += run.count;
  }
  return runs;
}

class Parter {
 public:
  explicit Parter(PointGrid grid) : grid_(std::move(grid)) {
    Box3 box;
    for (const Vec3& p : grid_.points) box.add(p);
    flat_ = kFlatGrid * box.diagonal();
    same_ = kSamePoint * box.diagonal();
    close();
  }

  SmoothGrids run(Rows rows) {
    SmoothGrids out;
    out.piece_of.assign(at(grid_.cell_rows()) * at(grid_.cell_columns()), -1);
    set_knots();
    const std::vector<Run> across = runs_between(smooth(column_turns(), grid_.columns_close),
                                                 grid_.cell_columns(), grid_.columns_close);
    const std::vector<double> between_rows = row_turns();
    std::vector<bool> steps;
    for (const double t : between_rows) steps.push_back(std::abs(t) <= kLargestStepOfGrid);
    const std::vector<Run> along =
        runs_between(rows == Rows::Steps ? steps : smooth(between_rows, grid_.rows_close),
                     grid_.cell_rows(), grid_.rows_close);
    for (const Run& r : along) {
      for (const Run& c : across) {
        if (PointGrid p = piece(r, c); !is_known_otherwise(p)) add(out, r, c, std::move(p));
      }
    }
    return out;
  }

 private:
  void add(SmoothGrids& out, const Run& r, const Run& c, PointGrid whole) const {
    const bool by_rows = meets_itself(r, grid_.cell_rows(), grid_.rows_close || rows_meet_);
    const bool by_columns =
        meets_itself(c, grid_.cell_columns(), grid_.columns_close || columns_meet_);
    const std::int32_t half_rows = by_rows ? r.count / 2 : r.count,
                       half_columns = by_columns ? c.count / 2 : c.count;
    const auto first = static_cast<std::int32_t>(out.pieces.size());
    for (std::int32_t j = 0; j < r.count; ++j) {
      for (std::int32_t i = 0; i < c.count; ++i) {
        const std::int32_t part = (j < half_rows ? 0
                                   : by_columns  ? 2
                                                 : 1) +
                                  (i < half_columns ? 0 : 1);
        out.piece_of[cell((r.first + j) % grid_.cell_rows(),
                          (c.first + i) % grid_.cell_columns())] = first + part;
      }
    }
    if (!by_rows && !by_columns) return out.pieces.push_back(std::move(whole));
    for (std::int32_t j = 0; j < (by_rows ? 2 : 1); ++j) {
      for (std::int32_t i = 0; i < (by_columns ? 2 : 1); ++i) {
        PointGrid part = whole;
        part.window = {j * half_rows, j == 0 ? half_rows : r.count - half_rows, i * half_columns,
                       i == 0 ? half_columns : c.count - half_columns};
        out.pieces.push_back(std::move(part));
      }
    }
  }
  /// Whether a run goes all round, from an edge to the same edge.
  static bool meets_itself(const Run& run, std::int32_t cells, bool closes) {
    return closes && !run.whole && run.count == cells;
  }

  bool same(Vec3 a, Vec3 b) const { return glm::distance(a, b) <= same_; }

  /// Loops from 0 to 360 degrees say the first row (column) again: what ends where it began closes.
  /// What ends there turned by some columns (rows) meets itself.
  void close() {
    const std::int32_t last_row = grid_.rows - 1, last_column = grid_.columns - 1;
    bool rows_again = !grid_.rows_close && last_row > 2,
         columns_again = !grid_.columns_close && last_column > 2;
    for (std::int32_t i = 0; i < grid_.columns; ++i) {
      rows_meet_ = rows_meet_ || same(grid_.point(0, i), grid_.point(last_row, 0));
      rows_again = rows_again && same(grid_.point(0, i), grid_.point(last_row, i));
    }
    for (std::int32_t j = 0; j < grid_.rows; ++j) {
      columns_meet_ = columns_meet_ || same(grid_.point(j, 0), grid_.point(0, last_column));
      columns_again = columns_again && same(grid_.point(j, 0), grid_.point(j, last_column));
    }
    if (!rows_again && !columns_again) return;
    PointGrid closed = grid_;
    closed.rows -= rows_again ? 1 : 0;
    closed.columns -= columns_again ? 1 : 0;
    closed.rows_close = grid_.rows_close || rows_again;
    closed.columns_close = grid_.columns_close || columns_again;
    closed.points.clear();
    for (std::int32_t j = 0; j < closed.rows; ++j) {
      for (std::int32_t i = 0; i < closed.columns; ++i) {
        closed.points.push_back(grid_.point(j, i));
      }
    }
    grid_ = std::move(closed);
  }

  std::size_t cell(std::int32_t row, std::int32_t column) const {
    return at(row) * at(grid_.cell_columns()) + at(column);
  }
  Vec3 side(std::int32_t row, std::int32_t column) const {
    return grid_.point(row, column + 1) - grid_.point(row, column);
  }
  /// Not of unit length; zero where the cell has no area.
  Vec3 normal(std::int32_t row, std::int32_t column) const {
    return glm::cross(grid_.point(row + 1, column + 1) - grid_.point(row, column),
                      grid_.point(row + 1, column) - grid_.point(row, column + 1));
  }
  static double turn(Vec3 a, Vec3 b, Vec3 edge) {
    const Vec3 across = glm::cross(a, b);
    const double angle = recognised::angle_between(a, b);
    return glm::dot(across, edge) < 0 ? -angle : angle;
  }

  /// Turns along a joint: the largest; negative where most bend inward. A bent bar turns outward on
  /// one side and inward on the other.
  struct JointTurn {
    double largest = 0, sum = 0, all = 0;
    void add(double turn) {
      largest = std::max(largest, std::abs(turn));
      sum += turn;
      all += std::abs(turn);
    }
    double signed_largest() const { return sum < -0.5 * all ? -largest : largest; }
  };

  /// For each joint its turn; `turn_at(joint, place)` is that at one of the places along it.
  template <class TurnAt>
  static std::vector<double> turns(std::int32_t cells, bool close, std::int32_t places,
                                   const TurnAt& turn_at) {
    std::vector<double> out;
    for (std::int32_t joint = 0; joint < (close ? cells : cells - 1); ++joint) {
      JointTurn turn;
      for (std::int32_t place = 0; place < places; ++place) turn.add(turn_at(joint, place));
      out.push_back(turn.signed_largest());
    }
    return out;
  }
  std::vector<double> column_turns() const {
    const std::int32_t cells = grid_.cell_columns();
    return turns(cells, grid_.columns_close, grid_.cell_rows(), [&](auto i, auto j) {
      const Vec3 edge = grid_.point(j + 1, i + 1) - grid_.point(j, i + 1);
      return turn(normal(j, i), normal(j, (i + 1) % cells), edge);
    });
  }
  std::vector<double> row_turns() const {
    const std::int32_t cells = grid_.cell_rows();
    return turns(cells, grid_.rows_close, grid_.cell_columns(), [&](auto j, auto i) {
      return turn(normal(j, i), normal((j + 1) % cells, i), side(j + 1, i));
    });
  }
  static std::vector<bool> smooth(const std::vector<double>& turns, bool closes) {
    return turns.empty() ? std::vector<bool>{}
                         : recognised::smooth_turns(turns, closes, {kUnequal, true});
  }

  /// Mean distances from row to row and from column to column.
  void set_knots() {
    const auto knots = [](std::int32_t spans, std::int32_t others, const auto& distance) {
      std::vector<double> out{0};
      for (std::int32_t k = 0; k < spans; ++k) {
        double sum = 0;
        for (std::int32_t o = 0; o < others; ++o) sum += distance(k, o);
        out.push_back(out.back() + std::max(sum / others, 1e-300));
      }
      return out;
    };
    grid_.row_knots = knots(grid_.cell_rows(), grid_.columns, [&](std::int32_t j, std::int32_t i) {
      return glm::distance(grid_.point(j, i), grid_.point(j + 1, i));
    });
    grid_.column_knots =
        knots(grid_.cell_columns(), grid_.rows, [&](std::int32_t i, std::int32_t j) {
          return glm::distance(grid_.point(j, i), grid_.point(j, i + 1));
        });
  }

  static std::vector<double> part_of(const std::vector<double>& knots, const Run& run) {
    const auto spans = static_cast<std::int32_t>(knots.size()) - 1;
    std::vector<double> out{0};
    for (std::int32_t k = 0; k < run.count; ++k) {
      const std::int32_t span = (run.first + k) % spans;
      out.push_back(out.back() + knots[at(span) + 1] - knots[at(span)]);
    }
    return out;
  }

  PointGrid piece(const Run& r, const Run& c) const {
    PointGrid out;
    out.rows = r.count + (r.whole ? 0 : 1);
    out.columns = c.count + (c.whole ? 0 : 1);
    out.rows_close = r.whole;
    out.columns_close = c.whole;
    for (std::int32_t j = 0; j < out.rows; ++j) {
      for (std::int32_t i = 0; i < out.columns; ++i) {
        out.points.push_back(grid_.point(r.first + j, c.first + i));
      }
    }
    out.row_knots = part_of(grid_.row_knots, r);
    out.column_knots = part_of(grid_.column_knots, c);
    return out;
  }

  /// Planes, and what is recognised by its facets.
  bool is_known_otherwise(const PointGrid& p) const {
    return narrow(p) || planar(p) || arcs_and_lines(p) || turned(p);
  }

  /// Cells without area have no surface to be on.
  bool narrow(const PointGrid& p) const {
    for (std::int32_t j = 0; j < p.cell_rows(); ++j) {
      for (std::int32_t i = 0; i < p.cell_columns(); ++i) {
        const Vec3 a = p.point(j, i), b = p.point(j, i + 1), d = p.point(j + 1, i);
        if (glm::distance(a, b) <= flat_ || glm::distance(a, d) <= flat_) return true;
      }
    }
    return false;
  }

  bool planar(const PointGrid& p) const {
    const Vec3 o = p.point(0, 0);
    Vec3 n(0);
    for (const Vec3& q : p.points) {
      const Vec3 m = glm::cross(p.point(0, 1) - o, q - o);
      if (glm::dot(m, m) > glm::dot(n, n)) n = m;
    }
    if (!(glm::dot(n, n) > 0)) return true;
    n = glm::normalize(n);
    return std::ranges::all_of(
        p.points, [&](const Vec3& q) { return std::abs(glm::dot(n, q - o)) <= flat_; });
  }

  /// Two rows of which one is the other, moved: sides that are all those of circles, or walls
  /// between such, are cylinders and planes.
  bool arcs_and_lines(const PointGrid& p) const {
    if (p.rows != 2) return false;
    const Vec3 up = p.point(1, 0) - p.point(0, 0);
    for (std::int32_t i = 1; i < p.columns; ++i) {
      if (glm::distance(p.point(1, i) - p.point(0, i), up) > flat_) return false;
    }
    return sides_of_circles(sides_of(p, up), p.columns_close);
  }

  /// A side of a polygon and the turn at its end, which the last side of an open one has not.
  struct Side {
    double length = 0, turn = 0;
    bool like(const Side& s) const {
      return std::abs(length - s.length) <= kEqual * length &&
             std::abs(turn - s.turn) <= kEqual * std::abs(turn);
    }
  };
  static std::vector<Side> sides_of(const PointGrid& p, Vec3 up) {
    std::vector<Side> out;
    const std::int32_t n = p.cell_columns();
    for (std::int32_t i = 0; i < n; ++i) {
      const Vec3 s = p.point(0, i + 1) - p.point(0, i);
      const bool last = i + 1 == n && !p.columns_close;
      out.push_back(
          {glm::length(s), last ? 0 : turn(s, p.point(0, i + 2) - p.point(0, i + 1), up)});
    }
    return out;
  }

  /// Each stretch of equal sides is a circle, each long side a line. Circles that follow one
  /// another and bend nearly alike are a spline.
  static bool sides_of_circles(std::vector<Side> sides, bool closes) {
    const std::size_t n = sides.size();
    if (closes) {
      for (std::size_t i = 0; i < n; ++i) {
        if (sides[i].like(sides[(i + n - 1) % n])) continue;
        std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(i), sides.end());
        break;
      }
    }
    double before = 0;  // how much the circle before bends, 1/mm
    for (std::size_t i = 0; i < n;) {
      std::size_t end = i + 1;
      while (end < n && sides[end - 1].like(sides[end])) ++end;
      // The last side turns at its end into what follows.
      if (end < n && std::abs(sides[end].length - sides[i].length) <= kEqual * sides[i].length) {
        ++end;
      }
      if (end - i >= kFewestSides) {
        const double bend = sides[i].turn / sides[i].length;
        if (before != 0 && bend / before > 1 / kOtherCircle && bend / before < kOtherCircle) {
          return false;
        }
        before = bend;
        i = end;
        continue;
      }
      const bool first = i == 0 && !closes, last = i + 1 == n && !closes;
      const double near =
          std::max(first ? 0 : sides[(i + n - 1) % n].length, last ? 0 : sides[(i + 1) % n].length);
      if (sides[i].length < recognised::kLong * near) return false;
      before = 0;
      ++i;
    }
    return true;
  }

  /// Rings around one axis, each a circle, with corners above corners.
  bool turned(const PointGrid& p) const { return rings(p, true) || rings(p, false); }
  bool rings(const PointGrid& p, bool by_rows) const {
    if (!(by_rows ? p.columns_close : p.rows_close)) return false;
    const std::int32_t count = by_rows ? p.rows : p.columns, corners = by_rows ? p.columns : p.rows;
    const auto point = [&](std::int32_t ring, std::int32_t k) {
      return by_rows ? p.point(ring, k) : p.point(k, ring);
    };
    Vec3 first(0), axis(0);
    for (std::int32_t r = 0; r < count; ++r) {
      Vec3 middle(0), area(0);
      for (std::int32_t k = 0; k < corners; ++k) middle += point(r, k) / double(corners);
      for (std::int32_t k = 0; k < corners; ++k) {
        area += glm::cross(point(r, k) - middle, point(r, (k + 1) % corners) - middle);
      }
      if (r == 0) first = middle, axis = normalize_or(area, Vec3(0));
      const Vec3 off = middle - first;
      if (glm::length(off - glm::dot(off, axis) * axis) > flat_) return false;
      const double radius = glm::distance(point(r, 0), middle);
      const double chord = glm::distance(point(r, 0), point(r, 1));
      for (std::int32_t k = 0; k < corners; ++k) {
        const Vec3 q = point(r, k) - middle;
        if (std::abs(glm::dot(q, axis)) > flat_) return false;
        if (std::abs(glm::length(q) - radius) > flat_) return false;
        if (glm::length(glm::cross(normalize_or(point(0, k) - first, q), q)) > flat_) return false;
        if (std::abs(glm::distance(point(r, k), point(r, (k + 1) % corners)) - chord) > flat_) {
          return false;
        }
      }
    }
    return true;
  }

  PointGrid grid_;
  double flat_ = 0, same_ = 0;
  /// Whether the last row (column) touches the first.
  bool rows_meet_ = false, columns_meet_ = false;
};

}  // namespace

SmoothGrids smooth_grids(PointGrid grid, Rows rows) { return Parter(std::move(grid)).run(rows); }

}  // namespace burin
