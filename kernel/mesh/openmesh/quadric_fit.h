#pragma once
/// A quadric height function fitted to points around a vertex.

#include <burin/base/vec.h>

#include <span>

namespace burin {

/// The unit normal at the origin of the surface z = a x + b y + c x^2 + d x y + e y^2 over the
/// plane of the unit vector `normal`, fitted to `points` (relative to the vertex) with weight 1 /
/// distance^2. The first `ring` of them are the vertex's own neighbours. Where the points do not
/// determine the curved terms, as on two parallel rims, the flattest solution through the ring
/// alone is taken. Returns the zero vector where there is none.
Vec3 quadric_normal(Vec3 normal, std::span<const Vec3> points, std::size_t ring);

}  // namespace burin
