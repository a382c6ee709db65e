#pragma once
// What is seen through each cell of a grid on paper: the target tone, and where there is paper
// only.

#include <burin/base/box.h>

#include "picture.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace burin::detail {

struct RasterCell {
  std::int32_t part = -1;  // -1: paper
  std::int32_t region = -1;
  double depth = 0;
  float darkness = 0;
  float facing = 0;  // cosine between the normal turned to the viewer and the view
  float denser = 1;  // by what factor strokes stand closer
  // Of the proxy: the triangle, and the barycentric coordinates of its second and third corner.
  std::uint32_t face = 0;
  float second = 0, third = 0;

  ProxyPoint place() const { return {face, {1.0 - second - third, second, third}}; }
};

struct ViewRaster {
  Vec2 origin{0};      // paper mm, lower left corner
  double pitch = 0.4;  // paper mm; wider on large sheets
  std::int32_t nx = 0, ny = 0;
  std::vector<RasterCell> cells;

  Vec2 center(std::int32_t x, std::int32_t y) const {
    return origin + pitch * Vec2(x + 0.5, y + 0.5);
  }
  /// Of the cell with that number.
  Vec2 center(std::size_t cell) const {
    const auto wide = static_cast<std::size_t>(nx);
    return center(static_cast<std::int32_t>(cell % wide), static_cast<std::int32_t>(cell / wide));
  }
  bool contains(Vec2 paper) const {
    const Vec2 q = (paper - origin) / pitch;
    return q.x >= 0 && q.y >= 0 && q.x < nx && q.y < ny;
  }
  /// Of the cell that a place lies in, or is nearest to.
  std::size_t index(Vec2 paper) const {
    const Vec2 q = (paper - origin) / pitch;
    const auto x = std::clamp(static_cast<std::int32_t>(q.x), 0, nx - 1);
    const auto y = std::clamp(static_cast<std::int32_t>(q.y), 0, ny - 1);
    return index(x, y);
  }
  std::size_t index(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(x);
  }
  const RasterCell& nearest(Vec2 paper) const { return cells[index(paper)]; }
  const RasterCell& at(std::int32_t x, std::int32_t y) const { return cells[index(x, y)]; }
};

/// Probes the sheet where the scene projects; no cell has a darkness yet. Cost: one ray a cell,
/// about 390,000 on A4, 2 million at most.
ViewRaster make_raster(const Picture& picture, const RunContext& context);

/// Gives each cell the darkness that the tone of the picture asks for.
void shade_raster(const Picture& picture, ViewRaster& raster, const RunContext& context);

}  // namespace burin::detail
