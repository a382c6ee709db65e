#pragma once
/// Sizes of unified screw threads, whose profile is that of metric ones.
/// @cite ASMEB11

#include <burin/threads/metric.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace burin {

/// Lengths in mm.
struct UnifiedSize {
  /// "1/4-20 UNC".
  std::string designation;
  double diameter = 0, pitch = 0;
};

/// "1/4 UNC", "1/4-20 UNC", "#10 UNF", "1 1/8-18 UNEF"; nothing where a text is none of these.
std::optional<UnifiedSize> unified_size(std::string_view text);
/// By the series, UNC, UNF or UNEF, and the number of the size in it, from the smallest, 0, on.
std::optional<UnifiedSize> unified_size(std::string_view series, std::size_t number);

/// What a designation says, metric or unified; nothing where it is neither.
std::optional<MetricSize> known_size(std::string_view text);

}  // namespace burin
