#pragma once
/// The two writers that need no library: SVG and the JSON drawing file.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>

#include <iosfwd>
#include <string>

namespace burin {

struct SvgOptions {
  /// Plain polylines of constant width instead of fitted curves and outlined strokes: for plotters
  /// and lasers.
  bool flatten_polylines = false;
  /// Largest distance in paper mm between a fitted cubic Bezier and the polyline it stands for.
  double fit_tolerance = 0.02;
  /// Dash and gap of hidden lines in paper mm.
  double dash = 2.0;
  double gap = 1.0;
  /// One element per layer and pen, for programs that are slow where there are many, and more only
  /// where one would be too long for Qt; says nothing of sources.
  bool merge = false;
  /// What every id begins with, so that several drawings can stand in one page.
  std::string id_prefix = {};
};

struct JsonOptions {
  /// Model coordinates beside the paper coordinates.
  bool points3 = true;
};

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
