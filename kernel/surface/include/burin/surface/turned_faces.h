#pragma once
/// Faces that an axis turns onto themselves: cylinders, cones, tori, spheres and other surfaces of
/// revolution, of any form that knows its faces.
/// @cite Gelfand2004

#include <burin/base/run_context.h>
#include <burin/base/vec.h>
#include <burin/surface/surface.h>

#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A line in space; `along` is a unit vector.
struct Axis {
  Vec3 point{0};
  Vec3 along{0, 0, 1};

  /// From the nearest point of the axis.
  Vec3 to(Vec3 p) const { return p - point - glm::dot(p - point, along) * along; }

  bool operator==(const Axis&) const = default;
};

/// A face of revolution, or a piece of one.
struct TurnedFace {
  /// As `ProxyMesh::face_source` numbers it.
  std::int32_t face = -1;
  /// Of a sphere any line through the point, its centre.
  Axis axis;
  bool sphere = false;
  /// Whether the normals point to the axis, as those of a hole do.
  bool hollow = false;
  /// Triangles of the proxy, ascending.
  std::vector<std::uint32_t> triangles;
};

/// What of the way round an axis there is, and along it, of some triangles of a proxy.
struct TurnedExtent {
  /// Each of 360 degrees, from any direction on.
  std::bitset<360> turn;
  /// Model mm from the axis's point, along it.
  double low = 0, high = 0;
  /// The largest distance from the axis, model mm.
  double radius = 0;

  /// What both have together. Both are of the same axis.
  void add(const TurnedExtent& other);
};

/// The faces of revolution of a surface, by number. A face is one where some turn moves none of its
/// points off it (slippage analysis of at most 192 points with their normals): the axes of exact
/// forms are as exact as their normals, those of meshes as good as their estimates. Planes are
/// none, nor are faces that cut a part open. Throws Cancelled. Cost: 192 frames a face at the most.
/// @cite Gelfand2004
std::vector<TurnedFace> turned_faces(const Surface& surface, const RunContext& context);

/// The same of one face, which has these triangles; its number is not set. Nothing where it is
/// none.
std::optional<TurnedFace> turned_face(const Surface& surface,
                                      const std::vector<std::uint32_t>& triangles);

/// The extent of triangles about an axis.
TurnedExtent extent_about(const Axis& axis, const ProxyMesh& proxy,
                          std::span<const std::uint32_t> triangles);

}  // namespace burin
