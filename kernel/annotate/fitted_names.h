#pragma once
// Names of rows on the sheet, cut to their columns; internal to the module.

#include <span>
#include <string>
#include <vector>

namespace burin::detail {

/// The names, no wider than `width` as letters of that height, mm. What is too long is cut at its
/// end, or, where others would read the same then, before what tells them apart: "Hexagon...M8x30".
std::vector<std::string> fitted_names(std::span<const std::string> names, double height,
                                      double width);

}  // namespace burin::detail
