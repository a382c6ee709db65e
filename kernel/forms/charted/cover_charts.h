#pragma once
// Algorithm 1 over all trimmed faces of a surface at once.

#include <burin/forms/charted/atlas.h>
#include <burin/surface/surface.h>

#include "locate.h"

#include <optional>
#include <vector>

namespace burin::detail {

/// Points uniform by area: a triangle is drawn by its size in (u,v) times the bound of |Su x Sv|
/// over its face, a place in it uniform in (u,v), and kept where a random number times the bound is
/// below |Su x Sv| there. So trimmed faces need no search for what is inside. Faces whose bound is
/// not proved, or so far above the mean that most candidates would be thrown away, draw their
/// triangles by area instead. @cite Elber1998
class ChartsCover {
 public:
  /// All must outlive this. Cost: 10 us a bicubic span, once.
  ChartsCover(const PlacedAtlas& atlas, const TriMesh& mesh, const UvTriangles& triangles,
              const RunContext& context);

  /// As Surface::cover. Cost: 0.2 us a candidate.
  std::vector<SurfacePoint> points(const CoverRequest& request, const RunContext& context) const;

 private:
  struct Draw;
  std::optional<SurfacePoint> candidate(const Draw& draw, const CoverRequest& request,
                                        std::size_t i) const;
  double weight(std::uint32_t triangle) const;

  const PlacedAtlas& atlas_;
  const TriMesh& mesh_;
  const UvTriangles& triangles_;
  // A face: a bound of |Su x Sv| in place; 0 = its triangles are drawn by area.
  std::vector<double> bound_;
};

}  // namespace burin::detail
