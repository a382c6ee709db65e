#pragma once
/// The two writers that need no library: SVG and the JSON drawing file.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>

#include <iosfwd>

namespace burin {

struct SvgOptions {
  /// Plain polylines of constant width instead of fitted curves and outlined strokes: for plotters
  /// and lasers.
  bool flatten_polylines = false;
  /// Largest distance in paper mm between a fitted cubic Bezier and the polyline it stands for.
  double fit_tolerance = 0.02;
};

struct JsonOptions {
  /// Model coordinates beside the paper coordinates.
  bool points3 = true;
};

/// Writes the drawing as SVG in true millimetres: one group a layer, inside it one group a part.
/// Numbers have a fixed format, so that the same drawing gives the same bytes everywhere. Does not
/// test the stream for errors.
void write_svg(const Drawing& drawing, const SvgOptions& options, std::ostream& out,
               const RunContext& context);

/// Writes the drawing file ("format": "burin-drawing", "version": 1).
void write_json(const Drawing& drawing, const JsonOptions& options, std::ostream& out,
                const RunContext& context);

}  // namespace burin
