#pragma once
// What of the level lines is drawn: where there is ink.

#include <burin/base/box.h>
#include <burin/base/smoothstep.h>

#include "picture.h"
#include "remembered.h"
#include "view_raster.h"

#include <cstdint>
#include <vector>

namespace burin::detail {

/// How a line fades into the light: it has all of its ink where `full` is asked for, and ends at
/// `least`.
struct FadingRange {
  double least = 0, full = 0;

  double weight(double ink) const { return full > least ? smoothstep(least, full, ink) : 1; }
};

/// A piece of a level line that is to be drawn.
struct Piece {
  LevelLine line;
  std::int32_t part = -1, region = -1;
  FadingRange fading;
  double length = 0;
  int halvings = 0;  // since a stroke stood at the middle of it
};

/// What is left of a piece before one of its points and after another, where that is a line.
std::vector<Piece> left_of(const Piece& piece, std::size_t before, std::size_t after);

/// The pieces of one smooth region and the box that they take.
struct Region {
  std::vector<Piece> pieces;
  Box2 box;
};

/// The pieces of all lines of a family in which there is enough ink, region by region.
std::vector<Region> regions_of(const Picture& picture, const ViewRaster& raster,
                               const std::vector<CellLine>& lines, int family);

}  // namespace burin::detail
