#pragma once
/// A proxy without what lies beyond a plane; internal to the room.

#include <burin/base/run_context.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/section/section.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace burin::detail {

/// Of a triangle that closes a cut.
inline constexpr std::uint32_t kNoFacet = std::numeric_limits<std::uint32_t>::max();

/// A triangle of the cut proxy: on which one of the whole proxy it lies, and where its corners are
/// there.
struct FacetPiece {
  std::uint32_t facet = kNoFacet;
  std::array<Vec3, 3> bary{};
};

struct CutProxy {
  ProxyMesh proxy;
  /// One a triangle of `proxy`; those of one facet follow each other, those that close the cut come
  /// last.
  std::vector<FacetPiece> pieces;
  /// Nothing lies beyond the plane, or all does: then the rest is empty.
  bool whole = false, gone = false;
  /// The loops do not close.
  bool open = false;
};

CutProxy cut_proxy(const ProxyMesh& whole, const CutPlane& plane, std::int32_t number,
                   const RunContext& context);

}  // namespace burin::detail
