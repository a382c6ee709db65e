#pragma once
/// The Surface of every form that is made of charts.

#include <burin/forms/charted/atlas.h>
#include <burin/surface/surface.h>

#include <memory>

namespace burin {

/// An atlas with its triangles as a surface. Positions, normals and curvature are those of S(u,v);
/// the triangles only tell where a face ends and what is next to it. `march`
/// follows the geodesic of S in (u,v) by adaptive steps of the fourth order, error below 1e-9 of
/// the size, crosses smooth edges and seams at the exact place on the edge with the direction
/// carried over, and stops at sharp edges and boundaries. `realised` meshes have gone through
/// set_wedge_normals and, where there is a view, cut_along_contours. Stage times are the caller's.
std::shared_ptr<const Surface> make_charted_surface(PlacedAtlas atlas, ChartMesh realised,
                                                    const RunContext& context);

}  // namespace burin
