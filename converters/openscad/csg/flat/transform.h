#pragma once
// Regions moved, turned, scaled and mirrored; for converters/openscad alone.

#include <burin/base/vec.h>

#include "solid.h"

namespace burin::csg {

/// x * p.x + y * p.y + origin.
struct Affine {
  Vec2 x{1, 0}, y{0, 1}, origin{0};
  double determinant() const { return cross2(x, y); }
  Vec2 operator()(Vec2 p) const { return p.x * x + p.y * y + origin; }
  Affine operator*(const Affine& inner) const {
    const auto turned = [&](Vec2 v) { return v.x * x + v.y * y; };
    return {turned(inner.x), turned(inner.y), (*this)(inner.origin)};
  }
};

/// Mirrored outlines are turned round. Arcs stay where circles stay circles, which the six digits
/// of a tree tell within a hundred thousandth.
Region transformed(const Region& region, const Affine& affine);

}  // namespace burin::csg
