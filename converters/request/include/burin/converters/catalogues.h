#pragma once
/// All that a user can choose from, as data for programs.

#include <string>

namespace burin {

/// One JSON object: "options" (as `request_to_json`, in the order of `all_options`), "style_keys"
/// (as `to_json` with "value", that of the style technical), "styles" and "stroke_kinds" ({"name",
/// "meaning"}), "formats" (suffixes), "stages" (of a run, as progress names them).
std::string catalogues_json();

}  // namespace burin
