#pragma once
/// What the writers of pictures make of a drawing: which paths stand in which layer, and which area
/// or line each of them is on paper. One code, so that all formats show the same.

#include <burin/drawing/bezier.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/format_options.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

/// The layer of all paths that are not visible, but for those that are drawn in full.
inline constexpr std::string_view kHiddenLayer = "hidden";

/// The layer of the lines on which parts of exploded views have come.
inline constexpr std::string_view kTrailLayer = "trail";

/// The layer of centre lines and centre marks.
inline constexpr std::string_view kCentreLayer = "centre";

/// The layer of the lines that stand for threads.
inline constexpr std::string_view kThreadLayer = "thread";

/// The layer of the lines along which views are cut for sections.
inline constexpr std::string_view kSectionPlaneLayer = "section-plane";

/// Whether the lines of a layer have long dashes and dots, as ISO 128-2 has axes and cutting
/// planes.
inline bool has_long_dashes(std::string_view layer) {
  return layer == kCentreLayer || layer == kSectionPlaneLayer;
}

/// The layer of the border between the drawing and empty paper.
inline constexpr std::string_view kOutlineLayer = "outline";

/// A layer as it is painted: its paths (two points or more, all numbers finite) by part.
struct InkLayer {
  std::string name;
  std::map<std::int32_t, std::vector<const Path*>> parts;
  /// Over the paths; those without letters or a finite place are left out.
  std::vector<const Text*> texts = {};
  /// "#rrggbb" where it has a colour of its own, else empty; and likewise its dashes.
  std::string color = {};
  std::vector<double> own_dashes = {};

  /// Lengths of ink and gaps in turn, paper mm; empty: its lines are not interrupted. Hidden lines
  /// are dashed; trails have a dot between dashes twice as long, centre lines and cutting planes
  /// between dashes three times as long; layers may say it themselves.
  std::vector<double> dashes(const DashOptions& options) const;
};

/// Lengths of ink and gaps for one path: stretched or shrunk, all by one factor, so that the path
/// begins and ends with a dash and has at least one; a closed path has whole periods. One dash
/// where the path is shorter than two with a gap. A centre line has a dash in its middle, where
/// others cross it.
std::vector<double> fitted_dashes(const std::vector<double>& dashes, const Path& path);

/// The layers in the order of painting. Hidden paths are gathered in the layer "hidden", which
/// comes first unless the drawing places it. Points into `drawing`.
std::vector<InkLayer> ink_layers(const Drawing& drawing);

/// A path on paper: the area inside `chains` by the nonzero rule, or lines along them of one width
/// with round ends and joins. A line without a curve is a dot at the path's first point.
struct Ink {
  bool filled = false;
  double width = 0;
  std::vector<std::vector<CubicBezier>> chains;
};

/// Paper mm: an area is painted by half of this beyond its border, under the line there, so that no
/// paper shows between it and the next one. Areas that are looked through are not.
inline constexpr double kTrap = 0.1;

/// Whether an area has a colour that is seen.
bool is_painted(const Area& area);

/// The areas that are painted, in the order of painting; they lie below all layers. Points into
/// `drawing`.
std::vector<const Area*> painted_areas(const Drawing& drawing);

/// That of the layer, or of the whole drawing: "#rrggbb".
const std::string& ink_color(const InkLayer& layer, const Drawing& drawing);

/// That of the path, of its layer, or of the whole drawing: "#rrggbb".
const std::string& ink_color(const Path& path, const InkLayer& layer, const Drawing& drawing);

/// Whether a path is a dot: a stroke, or the end of a leader, no longer than half its width. It is
/// painted as a line with round ends.
bool is_dot(const Path& path);

/// Whether a path is painted as an area, as far as its widths tell: `ink_of` decides.
bool wants_area(const Path& path);

/// The ink of a path, within `tolerance` mm. Strokes whose width varies, and those so wide that
/// their round caps would show, are areas; hidden paths that are dashed
/// are lines of their mean width.
Ink ink_of(const Path& path, double tolerance);

/// Whether every number of the path can be written.
bool is_finite(const Path& path);

/// The width all along the path, as seen: the mean of its widths, weighted by length; 0 without
/// any.
double mean_width(const Path& path);

/// Whether the widths differ so much that the eye or a measurement could tell (more than 0.01 mm).
bool has_varying_width(const Path& path);

/// Adds a spot ink that a drawing is printed in, but for one that it has; of no name: nothing.
void add_ink(const std::string& name, const std::string& color, Drawing& drawing);

}  // namespace burin
