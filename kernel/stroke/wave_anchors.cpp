#include "wave_anchors.h"

#include <cmath>
#include <numbers>

namespace burin::detail {
namespace {

constexpr double kAnchorFacing = 0.15;  // cosine: seen more edge-on, a border is a contour
constexpr double kMostSlant = 3;        // degrees between the lines and the border
constexpr int kAnchorHalvings = 6;

class Anchors {
 public:
  Anchors(const Picture& picture, const ViewRaster& raster, const WaveGraph& graph)
      : picture_(picture), raster_(raster), graph_(graph) {}

  std::vector<WaveAnchor> find(const RunContext& context) {
    for (std::uint32_t i = 0; i < graph_.nodes.size(); ++i) {
      if (i % 4096 == 0) context.check();
      look(i);
    }
    return std::move(out_);
  }

 private:
  bool same(const RasterCell& a, const RasterCell& b) const {
    return a.part == b.part && a.region == b.region;
  }

  // The cell beside one in the direction across the lines, where it lies beyond the border.
  void look(std::uint32_t node) {
    const std::uint32_t at = graph_.nodes[node].cell;
    const RasterCell& cell = raster_.cells[at];
    if (cell.facing < kAnchorFacing) return;
    const Vec2 wave = graph_.nodes[node].wave;
    const bool sideways = std::abs(wave.x) > std::abs(wave.y);
    const auto nx = static_cast<std::uint32_t>(raster_.nx);
    const auto x = static_cast<std::int32_t>(at % nx), y = static_cast<std::int32_t>(at / nx);
    for (const int way : {1, -1}) {
      const std::int32_t bx = x + (sideways ? way : 0), by = y + (sideways ? 0 : way);
      if (bx < 0 || by < 0 || bx >= raster_.nx || by >= raster_.ny) continue;
      const RasterCell& beyond = raster_.at(bx, by);
      if (same(cell, beyond)) continue;
      // What hides the border is no border.
      if (beyond.part >= 0 &&
          beyond.depth > cell.depth + Picture::slope(cell.facing, picture_.camera.scale())) {
        continue;
      }
      const Vec2 step = raster_.pitch * Vec2(sideways ? way : 0, sideways ? 0 : way);
      const Vec2 center = raster_.center(x, y);
      // The border at this cell and, for its direction, a cell further on either side.
      const double here = reach(cell, center, step);
      const Vec2 aside(step.y != 0 ? raster_.pitch : 0, step.x != 0 ? raster_.pitch : 0);
      const double before = reach(cell, center - aside, step),
                   after = reach(cell, center + aside, step);
      if (here < 0 || before < 0 || after < 0) continue;
      const Vec2 border = 2.0 * aside + (after - before) * step;
      const double slant = std::abs(glm::dot(glm::normalize(border), glm::normalize(wave)));
      if (slant > std::sin(kMostSlant * std::numbers::pi / 180)) continue;
      // From the border to the cell the phase turns by so much.
      out_.push_back({node, std::numbers::pi * (1 - 2 * here * glm::dot(wave, step))});
    }
  }

  // The share of a step from a place after which another surface is seen; -1: none, or at once.
  double reach(const RasterCell& cell, Vec2 from, Vec2 step) const {
    constexpr double kFar = 2;  // steps
    const auto is_own = [&](double t) {
      const auto hit = picture_.probe(from + t * step);
      return hit && hit->part == cell.part && hit->hatched &&
             picture_.surface(cell.part).proxy().face_region[hit->point.face] == cell.region;
    };
    if (!is_own(0) || is_own(kFar)) return -1;
    double low = 0, high = kFar;
    for (int k = 0; k < kAnchorHalvings + 1; ++k) {
      const double middle = 0.5 * (low + high);
      (is_own(middle) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  const Picture& picture_;
  const ViewRaster& raster_;
  const WaveGraph& graph_;
  std::vector<WaveAnchor> out_;
};

}  // namespace

std::vector<WaveAnchor> wave_anchors(const Picture& picture, const ViewRaster& raster,
                                     const WaveGraph& graph, int family,
                                     const RunContext& context) {
  if (family != 1) return {};
  return Anchors(picture, raster, graph).find(context);
}

}  // namespace burin::detail
