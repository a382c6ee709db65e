#pragma once
/// A triangle divided at points on its sides: the one way in which all forms do it.

#include <burin/base/vec.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace burin {

/// The pieces of a triangle, turned as it is. Corners 0, 1, 2 are the triangle's own; 3, 4, 5 the
/// points on the sides 0-1, 1-2, 2-0.
struct Division {
  using Piece = std::array<std::uint8_t, 3>;
  std::array<Piece, 4> pieces{};
  std::size_t count = 0;

  const Piece* begin() const { return pieces.data(); }
  const Piece* end() const { return pieces.data() + count; }
};

/// Bit k of `marks`: side k has a point. Two points leave a quadrangle, parted along its shorter
/// diagonal. Of `points` only those that are used have to be set.
Division divide(std::uint8_t marks, const std::array<Vec3, 6>& points);

/// The side of the triangle that a side of a piece, from corner p to q, lies on; -1 inside.
int side_of(std::uint8_t p, std::uint8_t q);

}  // namespace burin
