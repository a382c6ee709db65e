#pragma once
/// Triangles of one face that reach from one side of a seam to the other.

#include <burin/base/vec.h>
#include <burin/mesh/tri_mesh.h>

#include <vector>

namespace burin {

/// A few long triangles may go all the way round a closed face: once both sides of the seam are
/// one, two of their corners are the same vertex, or two of their edges the same pair. Splits edges
/// inside the face in the middle, those of both triangles alike, that are longer than a third of
/// `around`: the way in u and in v from one side of the seam to the other (0: no seam). New places
/// are added to `uv`; edges to places that are a pole (nonzero) lead round nothing.
void split_wide_triangles(std::vector<Vec2>& uv, std::vector<std::uint8_t>& pole,
                          std::vector<Triangle>& triangles, Vec2 around);

}  // namespace burin
