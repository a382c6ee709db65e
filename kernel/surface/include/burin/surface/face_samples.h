#pragma once
/// What is asked of single faces of a surface.

#include <burin/base/vec.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace burin {

/// A point of a surface with its normal.
struct SampledPoint {
  Vec3 position{0}, normal{0};
};

/// Points near the corners of triangles of a proxy, spread over these. Near all corners: the
/// middles of a fan, as of a cone, lie on one circle, which is on a ball. `about`: how many; of few
/// triangles there are three each, of many up to twice as many. Cost: a frame each.
std::vector<SampledPoint> face_samples(const Surface& surface,
                                       std::span<const std::uint32_t> triangles, std::size_t about);

/// The triangles of each face, as `ProxyMesh::face_source` numbers it, ascending; none of those
/// that close a cut. Cost: a pass over the triangles.
std::map<std::int32_t, std::vector<std::uint32_t>> triangles_of_faces(const ProxyMesh& proxy);

}  // namespace burin
