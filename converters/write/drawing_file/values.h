#pragma once
// The parts of a drawing file that are read by themselves. All throw InputError with the place.

#include <burin/camera/sheet.h>
#include <burin/drawing/drawing.h>

#include "json_place.h"

#include <string>
#include <vector>

namespace burin {

LineClass kind_named(const JsonPlace& place);
/// Appends; paper mm.
void read_points(const JsonPlace& place, std::vector<Vec2>& out);
void read_color(const JsonPlace& place, std::string& out);

Path read_path(const JsonPlace& place);
Text read_text(const JsonPlace& place);
/// Lengths of ink and gaps in turn; all 0 would never end.
void read_dashes(const JsonPlace& place, std::vector<double>& out);

/// Takes version 1 alone.
void check_version(const JsonPlace& place);
/// Everything but the layers.
void read_head(const JsonPlace& root, Drawing& drawing);

}  // namespace burin
