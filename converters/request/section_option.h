#pragma once
// What sections take as text; internal to the module.

#include <burin/arrange/section.h>
#include <burin/base/box.h>

#include <string>

namespace burin::detail {

/// "quarter", AXIS[=MM] or a list of those: across different axes one region, in turns across two
/// of them steps. Throws UsageError.
Section section_option(const std::string& spelled, const std::string& text);
/// The inside of a box x0,y0,z0,x1,y1,z1. Throws UsageError.
Section section_box_option(const std::string& spelled, const std::string& text);
Section section_of_box(const Box3& box);
/// X,Y,Z,R. Throws UsageError.
Section section_around_option(const std::string& spelled, const std::string& text);

/// What is wrong with the planes of steps; empty: nothing.
std::string wrong_steps(const std::vector<SectionPlane>& planes);

}  // namespace burin::detail
