#pragma once
// What each option of a drawing does to the plan; internal to the room.

#include <burin/converters/request.h>

#include <string>
#include <vector>

namespace burin::detail {

/// A plan while options are applied, one after the other.
struct Draft {
  DrawPlan plan{};
  /// The style as its name or file has it.
  Style named{};
  std::string style_text, style_source;
};

/// The heading of options about parts.
inline constexpr const char* kParts = "Parts";

const std::vector<RequestRow<Draft>>& draw_rows();
/// Of them, those about sections.
std::vector<RequestRow<Draft>> section_rows();

}  // namespace burin::detail
