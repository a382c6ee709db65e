#pragma once
// Names of colours that CSS has; internal to the module.

#include <string_view>
#include <vector>

namespace burin::detail {

/// "#rrggbb" of a name in small letters, such as "steelblue"; empty where CSS has none, or
/// `color_names` has it.
std::string_view css_color(std::string_view name);

/// All names that it knows.
std::vector<std::string_view> css_color_names();

}  // namespace burin::detail
