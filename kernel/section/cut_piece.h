#pragma once
/// What a triangle of a cut proxy is; internal to the module.

#include <burin/base/vec.h>

#include <array>
#include <cstdint>
#include <limits>

namespace burin::detail {

/// Names a directed edge between two vertices.
inline std::uint64_t edge_key(std::uint32_t from, std::uint32_t to) {
  return static_cast<std::uint64_t>(from) << 32U | to;
}

/// Of a triangle that closes a cut.
inline constexpr std::uint32_t kNoFacet = std::numeric_limits<std::uint32_t>::max();

/// A triangle of the cut proxy: on which one of the whole proxy it lies, and where its corners are
/// there.
struct FacetPiece {
  std::uint32_t facet = kNoFacet;
  std::array<Vec3, 3> bary{};
  /// Where it closes a cut: by which of the planes.
  std::int32_t plane = 0;
};

}  // namespace burin::detail
