#pragma once
/// Writers of the sample files, one a format, chosen by the suffix.

#include "kit.h"

#include <filesystem>

namespace burin::samples {

/// `.stl` (binary) and `.ply` (binary) and `.off` hold one mesh; `.obj` and `.3mf` keep the parts
/// and their names.
void write(const std::vector<Solid>& solids, const std::filesystem::path& path);

}  // namespace burin::samples
