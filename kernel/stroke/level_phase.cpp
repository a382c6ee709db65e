#include "level_phase.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace burin::detail {
namespace {

constexpr double kNearest = 0.05;  // paper mm
constexpr std::size_t kGrain = 1024;

std::optional<Level> level_at(const Picture& picture, const RasterCell& cell) {
  const Surface& surface = picture.surface(cell.part);
  const SurfacePoint point = surface.lift(cell.place());
  return picture.level(cell.part, point, surface.frame(point));
}

// Levels a paper mm that a level changes by where it changes most.
double climb(const Picture& picture, const RasterCell& cell, const Level& level) {
  const Surface& surface = picture.surface(cell.part);
  const ProxyPoint at = cell.place();
  const Vec3 position = surface.proxy().position(at.face, at.bary);
  const double slope = glm::length(level.gradient);
  if (!(slope > 0)) return 0;
  const double speed = glm::length(picture.camera.velocity(position, level.gradient / slope));
  return speed > 0 ? slope / speed : 0;
}

// The nearest of 1, 2, 5, 10 ... in their logarithms.
double round_number(double x) {
  const double power = std::pow(10, std::floor(std::log10(x))), lead = x / power;
  return power * (lead < std::sqrt(2.0)    ? 1
                  : lead < std::sqrt(10.0) ? 2
                  : lead < std::sqrt(50.0) ? 5
                                           : 10);
}

}  // namespace

double level_step(const Picture& picture, const ViewRaster& raster, const RunContext& context) {
  std::vector<double> climbs(raster.cells.size(), -1);
  parallel_for(
      climbs.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const RasterCell& cell = raster.cells[i];
          if (!has_node(cell)) continue;
          if (const auto level = level_at(picture, cell)) climbs[i] = climb(picture, cell, *level);
        }
      },
      &context);
  double sum = 0, count = 0;
  for (const double c : climbs) {
    if (c < 0) continue;
    sum += c;
    ++count;
  }
  if (!(sum > 0)) return 0;
  const double mean = sum / count;
  const double step = picture.options.level_step;
  if (step == 0) return round_number(mean * picture.options.spacing_min);
  if (step < kNearest * mean) {
    throw UsageError(
        fmt::format("lines {:g} apart in level would lie {:.2g} mm apart on paper on average; take "
                    "hatch.level_step of {:.2g} or more",
                    step, step / mean, kNearest * mean));
  }
  return step;
}

WavePhase level_phase(const Picture& picture, const ViewRaster& raster, WaveGraph& graph,
                      const RunContext& context) {
  const std::size_t n = graph.nodes.size();
  std::vector<double> turns(n, 0);
  parallel_for(
      n, kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto level = level_at(picture, raster.cells[graph.nodes[i].cell]);
          if (level) turns[i] = level->value / picture.level_step;
        }
      },
      &context);
  // The gradient of the turns at each node, by least squares over its links.
  struct Normal {
    double xx = 0, xy = 0, yy = 0;
    Vec2 right{0};
  };
  std::vector<Normal> normals(n);
  WavePhase phase;
  phase.at.resize(n);
  for (std::size_t i = 0; i < n; ++i) phase.at[i] = kTurn * (turns[i] - std::floor(turns[i]));
  for (WaveLink& link : graph.links) {
    link.flips = false;  // a level grows one way
    const double by = turns[link.b] - turns[link.a];
    phase.advance.push_back(kTurn * by);
    for (const std::uint32_t node : {link.a, link.b}) {
      Normal& m = normals[node];
      m.xx += link.step.x * link.step.x;
      m.xy += link.step.x * link.step.y;
      m.yy += link.step.y * link.step.y;
      m.right += by * link.step;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Normal& m = normals[i];
    const double det = m.xx * m.yy - m.xy * m.xy;
    constexpr double kLeast = 1e-6;
    if (det > kLeast * m.xx * m.yy) {
      graph.nodes[i].wave =
          Vec2(m.yy * m.right.x - m.xy * m.right.y, m.xx * m.right.y - m.xy * m.right.x) / det;
    }
  }
  return phase;
}

}  // namespace burin::detail
