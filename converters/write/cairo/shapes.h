#pragma once
/// The ink of a drawing, painted by cairo.

#include <burin/converters/write.h>
#include <burin/drawing/color.h>
#include <burin/drawing/ink.h>

#include <cairo.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace burin {

constexpr double kPointsPerMm = 72 / 25.4;
/// Shapes between two looks at whether the run is cancelled; a few ms of work.
constexpr std::size_t kAtOnce = 2048;

/// Paper mm: a curve that is a line within this distance is written as one; far below what shows.
inline constexpr double kStraight = 0.0005;

struct SurfaceDeleter {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using Surface = std::unique_ptr<cairo_surface_t, SurfaceDeleter>;

struct PenDeleter {
  void operator()(cairo_t* pen) const { cairo_destroy(pen); }
};
using Pen = std::unique_ptr<cairo_t, PenDeleter>;

/// A path, a text or an area, with its ink.
struct Shape {
  const Path* path = nullptr;
  /// Lengths of ink and gaps in turn, mm.
  std::vector<double> dashes = {};
  Ink ink = {};
  const Text* text = nullptr;
  Rgb color{};
  const Area* area = nullptr;
};

/// The areas and the paths of the layers in the order of painting, their ink still to be fitted.
std::vector<Shape> shapes_of(const std::vector<InkLayer>& layers, const Drawing& drawing,
                             const DashOptions& options);

/// What a format has for texts.
enum class TextsAs { Outlines, Letters };

/// Fits the ink of some shapes, all cores; texts that are letters have none. Throws Cancelled.
void fit_ink(std::span<Shape> shapes, double tolerance, TextsAs texts, const RunContext& context);

/// The colour that a pen paints in from now on.
void use(cairo_t* pen, const Rgb& color, double opacity = 1);

/// A pen that paints black on `surface` in paper mm, `scale` units of the surface a mm; the top of
/// the surface lies `top` units below that of the sheet.
Pen pen_on(cairo_surface_t* surface, double paper_height, double scale, double top);

/// Adds a shape to the pen's path.
void trace(cairo_t* pen, const Shape& shape);
/// Paints the pen's path, of shapes of the same pen as `shape`.
void paint_traced(cairo_t* pen, const Shape& shape);
bool same_pen(const Shape& a, const Shape& b);

/// Throws Error where cairo failed.
void check(cairo_status_t status);

}  // namespace burin
