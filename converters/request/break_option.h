#pragma once
// What breaks take as text; internal to the module.

#include <burin/arrange/break.h>

#include <string>

namespace burin::detail {

/// "auto", AXIS or AXIS:FROM..TO. Throws UsageError.
Break break_option(const std::string& spelled, const std::string& text);
/// x, y, z or X,Y,Z, as a unit vector. Throws UsageError.
Vec3 break_axis(const std::string& spelled, const std::string& text);

}  // namespace burin::detail
