#pragma once
/// What is laid over a sheet with several views: the circles of details and the symbol of the
/// projection method.

#include <burin/annotate/options.h>
#include <burin/camera/view_grid.h>
#include <burin/drawing/clip.h>
#include <burin/drawing/drawing.h>

#include <span>
#include <string>
#include <vector>

namespace burin {

/// A place of a view that is drawn again at another scale.
struct DetailMark {
  /// Where it lies in the view, and where it is drawn again, paper mm.
  Disc from, to;
  /// "A".
  std::string letter;
  /// Paper mm a model mm of what is drawn again.
  double scale = 1;
};

/// The circle of the place in the view, for what is laid out before it.
std::vector<Vec2> line_of(const DetailMark& mark);

/// Paper mm above a detail that its letter and scale need.
double detail_caption(const CalloutOptions& style);

/// Lays the layer "details" over a sheet: both circles in narrow lines, the letter at the first
/// where it meets least ink, letter and scale above the second. ISO 128-3.
void lay_details(Drawing& sheet, std::span<const DetailMark> marks, const CalloutOptions& style);

/// Paper mm: width and height of the symbol.
Vec2 projection_symbol_size();

/// The layer "projection": a truncated cone from the side and along its axis, as ISO 128-3 and ISO
/// 5456-2 have it, with its bottom left corner at a place.
Layer projection_symbol(ProjectionMethod method, Vec2 at, const CalloutOptions& style);

}  // namespace burin
