#pragma once
/// What a user chooses of the files that a drawing becomes, of all formats: those that other
/// modules write, too.

#include <burin/options/row.h>

#include <string>
#include <vector>

namespace burin {

/// Dashes of hidden lines, in paper mm; for every format.
struct DashOptions {
  double dash = 2.0;
  double gap = 1.0;

  bool operator==(const DashOptions&) const = default;
};

/// Which line of a layer comes after which.
enum class LineOrder {
  Drawing,  // as the drawing has them, part by part
  Travel,   // so that a pen travels little (burin/drawing/pen_order.h); those that meet are joined
};

struct SvgOptions {
  /// Plain polylines of constant width instead of fitted curves and outlined strokes: for plotters
  /// and lasers; for every format that has curves.
  bool flatten = false;
  /// One element per layer and pen, for programs that are slow where there are many, and more only
  /// where one would be too long for Qt; says nothing of sources.
  bool merge = false;
  /// Largest distance in paper mm between a fitted cubic Bezier and the polyline it stands for; for
  /// every format that has curves.
  double fit_tolerance = 0.02;
  DashOptions dashes{};
  /// Travel: there is no group a part.
  LineOrder order = LineOrder::Drawing;
  /// What every id begins with, so that several drawings can stand in one page. Of a file, not of a
  /// style: it has no row.
  std::string id_prefix = {};

  bool operator==(const SvgOptions&) const = default;
};

struct JsonOptions {
  /// Model coordinates beside the paper coordinates.
  bool points3 = true;

  bool operator==(const JsonOptions&) const = default;
};

struct PngOptions {
  /// Pixels per inch; also written into the file, so that pictures are shown in their true size.
  double dpi = 300;
  enum class Background { White, Transparent };
  Background background = Background::White;

  bool operator==(const PngOptions&) const = default;
};

struct DxfOptions {
  /// Lines of constant width as ARC, CIRCLE and ELLIPSE where they are such.
  bool arcs = true;
  /// Other smooth curves of constant width as SPLINE instead of LWPOLYLINE.
  bool splines = false;
  LineOrder order = LineOrder::Drawing;

  bool operator==(const DxfOptions&) const = default;
};

/// Names without a group: "dash"; "flatten"; "points3"; "dpi"; "splines" ...
std::vector<OptionRow<DashOptions>> dash_option_rows();
std::vector<OptionRow<SvgOptions>> svg_option_rows();
std::vector<OptionRow<JsonOptions>> json_option_rows();
std::vector<OptionRow<PngOptions>> png_option_rows();
std::vector<OptionRow<DxfOptions>> dxf_option_rows();

}  // namespace burin
