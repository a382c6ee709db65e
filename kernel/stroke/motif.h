#pragma once
// A drawing that stands on each point in the place of a stroke; internal to the module.

#include <burin/base/vec.h>
#include <burin/stroke/options.h>

#include <string>
#include <vector>

namespace burin::detail {

/// Lines about the origin in a plane, y up, whose box is 1 along its longer side.
struct Motif {
  struct Line {
    std::vector<Vec2> points;  // of a closed one the first is not repeated
    bool closed = false;
  };
  std::vector<Line> lines;
  double length = 0;  // of all lines
};

/// Lines of a mark, as a motif: not scaled, not moved.
Motif motif_of(const std::vector<std::vector<Vec2>>& lines);

/// Reads path data of SVG (burin/drawing/path_data.h). Its lines are within `tolerance`, in units
/// of the motif, of its curves. Throws UsageError where the text is no path, or a point.
Motif make_motif(const std::string& path, double tolerance);

/// That of the options, which have one. Throws UsageError that names the key, which begins with
/// `group`.
Motif motif_of(const HatchOptions& options, const std::string& group, double tolerance);

}  // namespace burin::detail
