#pragma once
/// Paths cut at the sides of a rectangle, at a circle, or at the sides of a strip.

#include <burin/base/box.h>
#include <burin/drawing/drawing.h>

#include <span>
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

/// What lies between two lines across a direction, paper mm along it, as wide as the sheet and
/// wider.
struct Strip {
  double low = 0, high = 0;
  /// Unit.
  Vec2 along{1, 0};
  /// How both lines run where they are not straight: points (across, along) from them, ascending
  /// across, where `across` is `along` turned left; straight between, and as the last one beyond.
  std::vector<Vec2> edge = {};

  Vec2 across() const { return {-along.y, along.x}; }
  /// Along `along` from the lines if these were at 0.
  double at(Vec2 p) const;
};

/// The same of a strip. Pieces whose sides are not straight have points where these have theirs.
bool lies_in(const Path& path, const Strip& strip);
std::vector<Path> clipped(const Path& path, const Strip& strip, const DrawingView* view = nullptr);
/// What is left in a strip of an area, inside an odd number of its rings.
std::vector<std::vector<Vec2>> clipped_rings(std::vector<std::vector<Vec2>> rings,
                                             const Strip& strip);

/// How far an edge runs from a line at a place across it: see `Strip::edge`.
double edge_at(std::span<const Vec2> edge, double across);

/// Cuts all paths and areas of a drawing at the sides; layers without a path left are gone, strokes
/// are counted anew.
void clip_to(const Box2& window, Drawing& drawing);
void clip_to(const Disc& disc, Drawing& drawing);

}  // namespace burin
