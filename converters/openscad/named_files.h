#pragma once
// Files that an OpenSCAD program names; internal to the module.

#include <filesystem>
#include <string_view>

namespace burin::detail {

/// Tells `InputFiles` of what a program in `folder` takes in by `include` and `use`, and these in
/// turn, and of files that its texts name (`import`, `surface`). Those of OpenSCAD's own library
/// folders are not looked for. Looks at 1,000 files at the most, of 16 MB each.
void note_named_files(std::string_view program, const std::filesystem::path& folder);

}  // namespace burin::detail
