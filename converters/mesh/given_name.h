#pragma once
/// What people call the objects of a mesh file.

#include <string>

namespace burin {

/// A name in a file as a person would have given it, in UTF-8 (`clean_name`). Slicers and CAD
/// programs call a mesh as the file that it came from: "C:\parts\foot.stl" is "foot". Numbers that
/// programs make up (UUIDs) are no names: empty.
std::string given_name(const std::string& name);

}  // namespace burin
