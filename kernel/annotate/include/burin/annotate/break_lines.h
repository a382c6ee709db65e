#pragma once
/// Break lines: where a broken view is cut.

#include <burin/drawing/drawing.h>
#include <burin/drawing/paper_breaks.h>
#include <burin/options/row.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace burin {

struct BreakOptions {
  enum class Line : std::uint8_t { Zigzag, Freehand };
  /// Both are lines of type 01.1. @cite ISO128part2
  Line line = Line::Zigzag;
  /// Paper mm of the lines: narrow, after ISO 128-2.
  double width = 0.18;
  /// Paper mm that are left of what is left out.
  double gap = 4;

  bool operator==(const BreakOptions&) const = default;
};

/// "line", "width", "gap".
std::vector<OptionRow<BreakOptions>> break_option_rows();

/// Where something of the parts is on a line across a view: paper mm across, ascending, apart.
using Stretches = std::vector<std::pair<double, double>>;

/// Stretches in any order as they are above: those that meet, paper mm, are one.
Stretches joined(Stretches stretches);

/// How break lines run (`Strip::edge`) where parts are cut: the zigzags or waves of each stretch.
std::vector<Vec2> break_edge(const Stretches& cut, BreakOptions::Line line);

/// Paper mm that break lines go on beyond the parts.
double break_reach(const BreakOptions& style);

/// Lays the layer "breaks" over a broken view: at both sides of each band a line along the edge,
/// over what is cut there; those with zigzags go on beyond. `cut`: of each side, low and high of
/// the first band, of the second, ...
void lay_break_lines(Drawing& drawing, const PaperBreaks& breaks, std::span<const Vec2> edge,
                     std::span<const Stretches> cut, const BreakOptions& style);

}  // namespace burin
