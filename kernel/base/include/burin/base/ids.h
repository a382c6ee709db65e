#pragma once
/// Where a line of the drawing comes from.

#include <compare>
#include <cstdint>

namespace burin {

/// Indices into the input, kept from the reader to every path of the output; -1 where there is
/// none. For meshes `face` is the index of the connected smooth region inside the part.
struct SourceId {
  std::int32_t part = -1;
  std::int32_t face = -1;
  std::int32_t edge = -1;

  friend bool operator==(const SourceId&, const SourceId&) = default;
  friend auto operator<=>(const SourceId&, const SourceId&) = default;
};

}  // namespace burin
