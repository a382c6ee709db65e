#pragma once
// --highlight: some parts in colour, all others pale; internal to the module.

#include "draw_options.h"

namespace burin::detail {

/// Adds a look of all parts, and one for each NAME or NAME=COLOUR.
void set_highlights(Draft& draft, const Asked& asked);

}  // namespace burin::detail
