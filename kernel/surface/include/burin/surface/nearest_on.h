#pragma once
/// The place of a surface that a ray at its proxy saw.

#include <burin/surface/surface.h>

namespace burin {

/// The point of a surface nearest to a place of its proxy, for what has to agree with rays at the
/// proxy. `lift` may lie beside it, along the surface, by many times the tolerance: on charts it is
/// linear in (u,v) between the corners of a triangle, which the triangles of a cone are not.
/// Cost: on planes that of `lift`, else seven times that.
SurfacePoint nearest_on(const Surface& surface, const ProxyPoint& place);

}  // namespace burin
