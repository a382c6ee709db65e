#pragma once
// Characters that the drawing font has not; internal to the module.

#include <burin/base/diagnostics.h>

#include <string>
#include <vector>

namespace burin::detail {

/// Warns once for all of these texts ("text.no_glyph").
void report_missing_letters(const std::vector<std::string>& texts, Diagnostics& diagnostics);

}  // namespace burin::detail
