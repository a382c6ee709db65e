#include "stroke_directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

constexpr double kCell = 2;               // paper mm
constexpr std::size_t kMost = 2'000'000;  // cells
constexpr double kStep = 1;               // paper mm along a line
/// Of ink in a cell: paper mm from which on it is hatched, and how much of one direction.
constexpr double kHatched = 2, kOneWay = 0.5;

bool is_hatching(const Path& path) {
  return path.visible && (path.kind == LineClass::Stroke || path.kind == LineClass::Pattern);
}

Vec2 doubled(Vec2 way) {
  const double square = glm::dot(way, way);
  return Vec2(way.x * way.x - way.y * way.y, 2 * way.x * way.y) / square;
}

}  // namespace

StrokeDirections::StrokeDirections(const Drawing& drawing) {
  Box2 box;
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!is_hatching(path)) continue;
      for (const Vec2& p : path.points) box.add(p);
    }
  }
  if (box.empty()) return;
  origin_ = box.min;
  const Vec2 count = glm::floor(box.size() / kCell) + 1.0;
  if (count.x * count.y > static_cast<double>(kMost)) return;  // far off any sheet
  width_ = static_cast<std::size_t>(count.x);
  height_ = static_cast<std::size_t>(count.y);
  cells_.resize(width_ * height_);
  for (const Layer& layer : drawing.layers) {
    for (const Path& path : layer.paths) {
      if (!is_hatching(path)) continue;
      for (std::size_t i = 1; i < path.points.size(); ++i) {
        const Vec2 way = path.points[i] - path.points[i - 1];
        const double length = glm::length(way);
        if (!(length > 0)) continue;
        const Cell* cell = at(0.5 * (path.points[i] + path.points[i - 1]));
        if (!cell) continue;
        Cell& sum = cells_[static_cast<std::size_t>(cell - cells_.data())];
        sum.doubled += length * doubled(way);
        sum.length += length;
      }
    }
  }
}

const StrokeDirections::Cell* StrokeDirections::at(Vec2 p) const {
  const Vec2 cell = glm::floor((p - origin_) / kCell);
  if (cell.x < 0 || cell.y < 0 || cell.x >= static_cast<double>(width_) ||
      cell.y >= static_cast<double>(height_)) {
    return nullptr;
  }
  return &cells_[static_cast<std::size_t>(cell.y) * width_ + static_cast<std::size_t>(cell.x)];
}

double StrokeDirections::along(Vec2 from, Vec2 to) const {
  const double length = glm::distance(from, to);
  if (cells_.empty() || !(length > 0)) return 0;
  const Vec2 way = doubled(to - from);
  const double cos_twice = std::cos(2 * 12 * std::numbers::pi / 180);
  const int steps = static_cast<int>(std::ceil(length / kStep));
  int parallel = 0;
  for (int i = 0; i < steps; ++i) {
    const Cell* cell = at(glm::mix(from, to, (i + 0.5) / steps));
    if (!cell || cell->length < kHatched) continue;
    const double one_way = glm::length(cell->doubled);
    if (one_way < kOneWay * cell->length) continue;
    parallel += glm::dot(cell->doubled, way) > cos_twice * one_way;
  }
  return length * parallel / steps;
}

}  // namespace burin::detail
