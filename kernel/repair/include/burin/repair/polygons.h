#pragma once
/// Polygons as triangles.

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

#include <cstdint>
#include <span>

namespace burin {

/// Cuts one polygon of n >= 3 corners into the n-2 triangles `out`; false where it crosses itself
/// (the triangles are then the least bad). Cost: O(n) convex, O(n r) with r reflex corners.
/// @cite Meisters1975
bool triangulate_polygon(std::span<const Vec3> positions, std::span<const std::uint32_t> corners,
                         std::span<Triangle> out, const RunContext& context);

}  // namespace burin
