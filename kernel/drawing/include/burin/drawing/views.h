#pragma once
/// Several views on one sheet.

#include <burin/drawing/drawing.h>

namespace burin {

/// Adds to a sheet what a drawing on the same sheet shows: lines and texts to layers of the same
/// name (new layers stand behind the one that they followed), areas, counts, what a test against
/// rays found, and diagnostics that the sheet does not tell yet. Parts, items and views stay those
/// of the sheet.
void append_view(Drawing& sheet, Drawing&& view);

/// Adds diagnostics that are not among the others yet.
void append_new(const Diagnostics& from, Diagnostics& to);

}  // namespace burin
