#pragma once
/// Reading the drawing file ("format": "burin-drawing", "version": 1), of Burin or of another
/// program.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace burin {

/// The drawing in a file; `write_json` gives back the same bytes for a file that it wrote. Needed
/// are "format", "version", the paper's "width" and "height", "layers", and of each path "points".
/// Anything else may be missing (a path without "width" is 0.25 mm wide, one without "kind" is a
/// contour), unknown keys are passed over. What is there must be right: InputError says where it is
/// not, by the line of broken JSON ("FILE:12: ...") or the place in the data ("FILE:
/// layers[3].paths[17].points[2]: ..."). Throws Cancelled. Cost: about 1 us per point, and the file
/// in memory.
Drawing read_drawing(const std::filesystem::path& path, const RunContext& context);

/// The same for text in memory; `file` names it in errors.
Drawing parse_drawing(std::string_view json, const std::string& file, const RunContext& context);

}  // namespace burin
