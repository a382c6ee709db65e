#pragma once
// Exact numbers: points and planes in homogeneous whole numbers; for csg/solids alone.

#include <burin/base/vec.h>

#include "../tree.h"

#include <gmpxx.h>

#include <array>

namespace burin::csg {

/// A point (x/w, y/w, z/w) with w > 0, or a plane x X + y Y + z Z + w = 0.
struct Exact {
  std::array<mpz_class, 4> c;
};

/// Affine, its entries exact: what nested multmatrix nodes come to without rounding, so that boxes
/// turned together still share their faces.
struct ExactMatrix {
  std::array<std::array<mpq_class, 4>, 3> row;
  /// The same to the nearest double, and whether that is all of it.
  Matrix nearest;
  /// Of each row: whether `nearest` says all of its last entry, as a decimal.
  std::array<bool, 3> plain{true, true, true};
  bool identity = true;
};

/// What the shortest decimal that reads as `v` says: the texts hold decimals, and 0.1 + 0.2 is to
/// be 0.3. `v` is finite.
mpq_class decimal(double v);

ExactMatrix exact(const Matrix& m);
/// Entries beyond 2,000 bits (nests of dozens of turned nodes) are rounded to doubles.
ExactMatrix multiply(const ExactMatrix& a, const ExactMatrix& b);
/// Of a matrix that flattens nothing.
ExactMatrix inverse(const ExactMatrix& m);
Exact transformed(const ExactMatrix& m, Vec3 p);

/// Of decimals, as is `transformed`.
Exact exact_point(Vec3 p);
/// The plane through three points, not normalised; all zero where they lie on a line.
Exact plane_through(const Exact& a, const Exact& b, const Exact& c);
/// Where the line through two points meets a plane.
Exact meet(const Exact& u, const Exact& v, const Exact& plane);
Exact meet_planes(const Exact& p, const Exact& q, const Exact& r);
/// The side of a plane on which a point lies: -1, 0, 1.
int side(const Exact& point, const Exact& plane);
/// The sign of a's coordinate less b's.
int compare(const Exact& a, const Exact& b, std::size_t axis);
bool equal_points(const Exact& a, const Exact& b);
/// The turn of three points in the plane of axes (i, j).
int turn(const Exact& a, const Exact& b, const Exact& c, std::size_t i, std::size_t j);
/// In the same plane, of three points that turn counter-clockwise: the sign of a point within (1)
/// or outside of (-1) the circle through them.
int in_circle(const std::array<const Exact*, 3>& triangle, const Exact& point, std::size_t i,
              std::size_t j);
Vec3 nearest(const Exact& point);

}  // namespace burin::csg
