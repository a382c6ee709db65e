#pragma once
/// Paths as SVG writes them: what the attribute `d` of a path says.

#include <burin/base/vec.h>
#include <burin/drawing/bezier.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// One stroke of a pen: a chain of curves, each starting where the one before ends. A closed one
/// ends where it starts.
struct Subpath {
  std::vector<CubicBezier> curves;
  bool closed = false;
};

/// Reads path data: M L H V C S Q T A Z and their relative forms, in the coordinates of the text (y
/// down). Lines become straight curves, arcs curves of up to a quarter turn (off by at most 3e-4 of
/// the radius). Subpaths that draw nothing are left out. Throws UsageError, "column 5: ...", where
/// the text is no path or stops within a command, draws nothing, has a number beyond 1e9, more than
/// 200,000 characters or more than 20,000 curves.
std::vector<Subpath> parse_path_data(std::string_view text);

/// Path data that `parse_path_data` reads back, each number to 7 digits.
std::string to_path_data(std::span<const Subpath> path);

/// The points of a subpath, so many that the curves are nowhere farther than `tolerance` from the
/// lines between them; a closed one does not repeat its first. Curves are divided into 256 pieces
/// at the most.
std::vector<Vec2> flattened(const Subpath& path, double tolerance);

}  // namespace burin
