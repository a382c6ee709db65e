#pragma once
// What notes take as text; internal to the module.

#include <burin/arrange/illustration.h>

#include "draw_options.h"

#include <string>
#include <vector>

namespace burin::detail {

/// A note of these words, which `known_note_values` may stand in. Throws UsageError.
DimensionRow note_of(const std::string& spelled, const std::string& text);
/// What may be in the braces of a note, as users read it.
std::string known_note_values();
/// "NAME=TEXT" or "X,Y,Z=TEXT". Throws UsageError.
DimensionRow note_option(const std::string& spelled, const std::string& text);

std::vector<RequestRow<Draft>> note_rows();

}  // namespace burin::detail
