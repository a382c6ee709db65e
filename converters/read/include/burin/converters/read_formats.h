#pragma once
/// What kinds of model files are read, in words.

#include <string>
#include <vector>

namespace burin {

/// One text a reader that Burin was built with, for help: "STEP, IGES, BREP", "glTF (.gltf, .glb)".
std::vector<std::string> read_formats();

}  // namespace burin
