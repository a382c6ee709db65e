#pragma once
// What the objects of a program are called in its own text; internal to the module.

#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

/// For each of `count` objects at the top of what the program makes, in order, the name of the
/// module that makes it: of `translate([1, 0, 0]) color("red") arm();` it is "arm". Empty for
/// modules of OpenSCAD itself, and for all where objects and statements cannot be told to belong
/// together (conditions of which some hold, files that are included). Linear in the text.
std::vector<std::string> source_names(std::string_view program, std::size_t count);

}  // namespace burin::detail
