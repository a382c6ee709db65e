#pragma once
// What the flat colours of two drawings differ by; internal to the module.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/revisions/line_changes.h>

#include <string>
#include <vector>

namespace burin::detail {

/// Name of a part of a drawing; empty where it has none of that id.
std::string part_name(const Drawing& drawing, std::int32_t id);

/// See `compare_drawings`.
std::vector<ChangedFill> compare_fills(const Drawing& before, const Drawing& after,
                                       double tolerance, const RunContext& context);

/// The spot inks of each drawing that the other has not, or in another colour.
std::vector<ChangedInk> compare_inks(const Drawing& before, const Drawing& after);

/// The areas of parts whose colours have changed, as the new drawing paints them, and the borders
/// of what either paints of them.
struct FillPicture {
  std::vector<Area> areas;
  std::vector<Path> borders;
};
FillPicture picture_of(const std::vector<ChangedFill>& fills, const Drawing& before,
                       const Drawing& after);

}  // namespace burin::detail
