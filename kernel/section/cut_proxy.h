#pragma once
/// A proxy without what lies beyond all planes of a region; internal to the module.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/section/section.h>
#include <burin/surface/surface.h>

#include "cut_piece.h"

#include <cstdint>
#include <vector>

namespace burin::detail {

struct CutProxy {
  ProxyMesh proxy;
  /// One a triangle of `proxy`; those of one facet follow each other, those that close the cut come
  /// last.
  std::vector<FacetPiece> pieces;
  /// Nothing lies beyond the planes, or all does: then the rest is empty.
  bool whole = false, gone = false;
  /// The loops do not close.
  bool open = false;
};

/// Regions that close plane i of `region` have the number `number` + i.
CutProxy cut_proxy(const Surface& surface, const CutRegion& region, std::int32_t number,
                   const RunContext& context);

}  // namespace burin::detail
