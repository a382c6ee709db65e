#pragma once
/// libburin_cairo, loaded when it is first asked for.

#include "cairo/cairo_library.h"

namespace burin {

/// Throws Error, one sentence, where it cannot be used.
const CairoLibrary& cairo_library();

}  // namespace burin
