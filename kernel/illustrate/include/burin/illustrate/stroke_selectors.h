#pragma once
/// Which parts have strokes.

#include <burin/illustrate/style.h>

#include <string>
#include <vector>

namespace burin {

/// The selectors of `HatchStyle::select`; none where all parts have these strokes.
std::vector<std::string> selectors_of(const HatchStyle& hatch);

}  // namespace burin
