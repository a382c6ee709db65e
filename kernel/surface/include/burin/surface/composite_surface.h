#pragma once
/// Several surfaces as one.

#include <burin/surface/surface.h>

#include <memory>
#include <vector>

namespace burin {

/// The pieces of a part side by side, unjoined: where two of them meet, both end. Their proxies
/// stand one after the other in one mesh, regions and components numbered on; the
/// triangle of a SurfacePoint tells the piece, its chart is that of the piece. Every piece's proxy
/// knows its source faces or none does. Throws GeometryError where there is no piece.
std::shared_ptr<const Surface> make_composite_surface(
    std::vector<std::shared_ptr<const Surface>> pieces);

}  // namespace burin
