#pragma once
/// The two writers that need no library: SVG and the JSON drawing file.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/drawing/format_options.h>

#include <iosfwd>

namespace burin {

/// Writes the drawing as SVG in true millimetres: one group per layer, inside it one group per
/// part. Paths of constant width are stroked, strokes whose width varies are filled outlines (class
/// and data the same). Paths that are not visible are dashed, at their mean width, and stand in
/// the layer "hidden", which comes first unless the drawing places it. Paths with numbers that are
/// not finite are left out. Numbers have a fixed format (0.001 mm), so that the same drawing gives
/// the same bytes everywhere, for any number of threads. Does not test the stream for errors.
/// Throws Cancelled. Cost: about 0.2 us per point, all cores. @cite SVG11
void write_svg(const Drawing& drawing, const SvgOptions& options, std::ostream& out,
               const RunContext& context);

/// Writes the drawing file ("format": "burin-drawing", "version": 1), one path per line. Paper
/// coordinates and widths are rounded to 0.0001 mm, model coordinates to what a millionth of a
/// paper mm is in the model; the rest is exact. Paths with numbers that are not finite are left out
/// and counted as the diagnostic "drawing.not_finite". Does not test the stream for errors. Throws
/// Cancelled. Cost: about 0.15 us per point, all cores.
void write_json(const Drawing& drawing, const JsonOptions& options, std::ostream& out,
                const RunContext& context);

}  // namespace burin
