#pragma once
/// What the writers ask of a path.

#include <burin/drawing/drawing.h>

namespace burin {

/// Whether every number of the path can be written.
bool is_finite(const Path& path);

/// The width all along the path, as seen: the mean of its widths, weighted by length; 0 without
/// any.
double mean_width(const Path& path);

/// Whether the widths differ so much that the eye or a measurement could tell (more than 0.01 mm).
bool has_varying_width(const Path& path);

}  // namespace burin
