#pragma once
// What each option of a drawing does to the plan; internal to the module.

#include <burin/converters/request.h>

#include "style_files.h"

#include <string>
#include <utility>
#include <vector>

namespace burin::detail {

/// A plan while options are applied, one after the other.
struct Draft {
  DrawPlan plan{};
  /// Those of the plan, whose styles start from its own.
  std::vector<LookRequest> looks{};
  /// The style as its name or file has it.
  LoadedStyle named{};
  std::string style_text, style_source;
};

/// Past any sheet, scale or tolerance that means something.
inline constexpr double kLarge = 1e12;
/// The word for the largest scale of ISO 5455 that fits.
inline constexpr const char* kIsoScale = "iso";
inline constexpr const char* kDirectionPhrase = "a direction X,Y,Z other than 0,0,0";
/// The heading of options about parts.
inline constexpr const char* kParts = "Parts";
inline constexpr const char* kSheet = "The sheet and the view";

/// Parts and what is said of them, "NAME=VALUE"; selectors may have the sign, too:
/// @color=#ff0000=VALUE. Throws UsageError with what the option takes where one of both is missing.
std::pair<std::string, std::string> name_and_value(const std::string& spelled,
                                                   const std::string& takes,
                                                   const std::string& text);

const std::vector<RequestRow<Draft>>& draw_rows();
/// Of them, those about the look, of all and of parts, about sections, about the view and about the
/// sheet.
std::vector<RequestRow<Draft>> look_option_rows();
std::vector<RequestRow<Draft>> part_option_rows();
std::vector<RequestRow<Draft>> section_rows();
std::vector<RequestRow<Draft>> view_rows();
std::vector<RequestRow<Draft>> sheet_rows();

}  // namespace burin::detail
