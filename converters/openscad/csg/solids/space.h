#pragma once
// The points, lines and planes of one Boolean, each known once; for csg/solids alone.

#include "number.h"

#include <boost/container/small_vector.hpp>

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <memory_resource>
#include <unordered_map>
#include <vector>

namespace burin::csg {

constexpr double kUlp = std::numeric_limits<double>::epsilon();

using Id = std::uint32_t;
inline constexpr Id kNone = ~Id{0};

/// Decisions are exact: doubles with a bound of their error first, whole numbers where the bound
/// does not decide. Constructions do not nest: a point is a corner of a leaf, or lies where a line
/// of two corners or of two planes meets a plane, and planes go through corners of leaves.
class Space {
 public:
  /// No coordinate will be larger than `size` mm.
  explicit Space(double size);

  Id add_matrix(ExactMatrix m);
  /// The point m * local; the same Id for the same place.
  Id corner(Vec3 local, Id matrix);
  /// The plane through three corners that are on no line, and whether its normal is the one of
  /// (b - a) x (c - a).
  std::pair<Id, bool> plane(Id a, Id b, Id c);
  /// Some plane through two corners that is not `plane`, in which they lie.
  Id plane_beside(Id a, Id b, Id plane);
  /// A point is known to lie in a plane.
  void lies_in(Id point, Id plane);
  /// The edge between two corners, in both planes. Two edges in one pair of planes share a line.
  Id line(Id a, Id b, Id p, Id q);
  /// The line of two planes where it is known already, else kNone.
  Id find_line(Id p, Id q) const;
  /// Where two planes meet that are not parallel.
  Id line(Id p, Id q);
  /// Where a line meets a plane that it is not parallel to. `near`, within `error` mm of it, saves
  /// solving for it; error < 0 = unknown.
  Id meet(Id line, Id plane, Vec3 near = Vec3{0}, double error = -1);

  int side(Id point, Id plane);
  /// Which comes first along a line.
  int along(Id line, Id a, Id b);
  /// The sign of a's coordinate less b's.
  int compare(int axis, Id a, Id b);
  /// The turn of a, b, c seen in the projection of a plane along its main axis: their sign in the
  /// plane up to a factor that is the plane's own.
  int turn(Id plane, Id a, Id b, Id c);
  /// In the same projection, of a triangle that turns counter-clockwise: 1 where a point lies
  /// within the circle through its corners, -1 outside, 0 on it.
  int in_circle(Id plane, const std::array<Id, 3>& triangle, Id point);
  /// Of the projection, for sizes: twice the area, and its bound of error.
  std::pair<double, double> area(Id plane, Id a, Id b, Id c) const;

  Vec3 at(Id point) const { return points_[point].at; }
  double error(Id point) const { return points_[point].error; }
  const Exact& exact_point(Id point);
  const Exact& exact_plane(Id plane);
  Vec3 normal(Id plane) const { return planes_[plane].n; }
  /// Signed distance (mm) of a place from a plane, and its bound of error where the place is exact.
  std::pair<double, double> distance(Id plane, Vec3 at) const;
  /// The axis that its normal is nearest to.
  int main_axis(Id plane) const { return planes_[plane].axis; }
  /// The plane of a line that is not `plane`.
  Id other_plane(Id line, Id plane) const {
    const Line& l = lines_[line];
    return l.p != plane ? l.p : l.q;
  }
  double size() const { return size_; }
  std::size_t points() const { return points_.size(); }
  /// How often doubles did not decide.
  std::size_t exact_count = 0;

 private:
  struct Point {
    Vec3 at;
    double error = 0;
    // A corner's place before `matrix`; else where `line` meets `plane`.
    Vec3 local{0};
    Id matrix = kNone, line = kNone, plane = kNone;
    boost::container::small_vector<Id, 4> planes;
    std::unique_ptr<Exact> exact;
    /// Another one in the same cell.
    Id next = kNone;
  };
  struct Line {
    Id p = 0, q = 0;
    // Two corners, where it has them.
    Id a = kNone, b = kNone;
    int axis = 0;
    double sign = 1;
  };
  struct Plane {
    Vec3 n;
    double d = 0;
    double n_error = 0, d_error = 0;
    std::array<Id, 3> corners{};
    int axis = 0;
    std::unique_ptr<Exact> exact;
  };
  struct Key {
    std::array<Id, 3> planes;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& k) const;
  };

  bool knows(Id point, Id plane) const;
  /// Where a corner comes to lie on a decimal; false where that is not sure.
  bool place_plainly(Point& point) const;
  void place(Point& point) const;
  /// The exact place of a point that has no number yet.
  Exact solve(const Point& point);
  void locate(Point& point);
  /// Gives a point its number unless `same` holds for one at its place.
  template <typename Same>
  Id number(Point&& point, Same&& same);
  std::uint64_t cell(Vec3 at, std::array<int, 3> shift) const;
  void fit(Plane& plane);
  Id add_line(Line line);

  double size_, reach_, cell_;
  std::vector<ExactMatrix> matrices_;
  std::vector<Point> points_;
  std::vector<Line> lines_;
  std::vector<Plane> planes_;
  // Millions of small entries that end together.
  std::pmr::monotonic_buffer_resource memory_;
  /// The last point of each cell.
  std::pmr::unordered_map<std::uint64_t, Id> cells_{&memory_};
  std::pmr::multimap<double, Id> plane_order_{&memory_};
  std::pmr::unordered_map<std::uint64_t, Id> line_of_planes_{&memory_};
  std::pmr::unordered_map<Key, Id, KeyHash> point_of_planes_{&memory_};
};

}  // namespace burin::csg
