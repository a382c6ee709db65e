#pragma once
/// Paths cut at the sides of a rectangle, or at a circle.

#include <burin/base/box.h>
#include <burin/drawing/drawing.h>

#include <vector>

namespace burin {

/// What a circle bounds, paper mm.
struct Disc {
  Vec2 center{0};
  double radius = 0;

  bool operator==(const Disc&) const = default;
};

/// Whether all points of a path lie in the rectangle (paper mm).
bool lies_in(const Path& path, const Box2& window);

/// The pieces of a path in the rectangle, each of them open, in their order along it; widths, model
/// points and faces go with them. `view` says how model points lie to those of the paper (absent:
/// straight in proportion, as in orthographic views). @cite LiangBarsky1984
std::vector<Path> clipped(const Path& path, const Box2& window, const DrawingView* view = nullptr);

/// The same of a disc.
bool lies_in(const Path& path, const Disc& disc);
std::vector<Path> clipped(const Path& path, const Disc& disc, const DrawingView* view = nullptr);

/// Cuts all paths and areas of a drawing at the sides; layers without a path left are gone, strokes
/// are counted anew.
void clip_to(const Box2& window, Drawing& drawing);
void clip_to(const Disc& disc, Drawing& drawing);

}  // namespace burin
