#pragma once
/// Coarse facets divided until they follow the surface that they stand for.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// A proxy made of another one by dividing its facets.
struct RoundedFacets {
  ProxyMesh proxy;
  /// For each wedge of `proxy` where it lies on the facets that were divided.
  std::vector<ProxyPoint> wedge_origin;
  /// For each triangle of `proxy` the facet that it is a piece of, or is.
  std::vector<std::uint32_t> face_origin;
  /// Facets stay farther from the surface than twice the tolerance, as more triangles were not
  /// allowed.
  bool cut_short = false;
};

/// Divides edges by halves until the chords of the smooth surface (RoundedMesh) over `coarse` lie
/// within `tolerance` model mm of it; facets within it stay as they are, creases and flat faces
/// too. Lines, strokes and what hides them then belong to one surface. Nothing where all facets
/// are within the tolerance. At most `most` triangles are made beyond those that are there. The
/// order of triangles and regions is kept. Triangles that are nonzero in `exact` (one a triangle,
/// or none at all) lie on a surface that is known: they keep their edges and normals. Cost: one
/// pass over the edges where nothing is to be done, else about 3 us per triangle that is made, its
/// share of the new proxy included.
std::optional<RoundedFacets> round_facets(const ProxyMesh& coarse, double tolerance,
                                          std::size_t most, const RunContext& context,
                                          std::span<const std::uint8_t> exact = {});

}  // namespace burin
