#include "motif.h"

#include <burin/base/box.h>
#include <burin/base/error.h>
#include <burin/drawing/path_data.h>

#include <fmt/format.h>

#include <algorithm>

namespace burin::detail {
namespace {

// Of the control points' box: what that of the curves may be off.
constexpr double kBoxTolerance = 1e-5;

}  // namespace

Motif make_motif(const std::string& path, double tolerance) {
  const std::vector<Subpath> subpaths = parse_path_data(path);
  Box2 box, controls;
  for (const Subpath& sub : subpaths) {
    for (const CubicBezier& c : sub.curves) {
      for (const Vec2& p : c) controls.add(p);
    }
  }
  for (const Subpath& sub : subpaths) {
    for (const Vec2& p : flattened(sub, kBoxTolerance * controls.diagonal())) box.add(p);
  }
  const double size = std::max(box.size().x, box.size().y);
  Motif motif;
  for (const Subpath& sub : subpaths) {
    // Half of the tolerance for the curves, half for leaving points out.
    const std::vector<Vec2> points = flattened(sub, 0.5 * tolerance * size);
    Motif::Line line{{}, sub.closed};
    for (const std::size_t i : simplify(points, 0.5 * tolerance * size)) {
      const Vec2 p = (points[i] - box.center()) / size;
      line.points.emplace_back(p.x, -p.y);
    }
    const std::size_t n = line.points.size();
    if (n < 2) continue;
    for (std::size_t i = 1; i < n; ++i) {
      motif.length += glm::distance(line.points[i - 1], line.points[i]);
    }
    if (line.closed) motif.length += glm::distance(line.points.back(), line.points.front());
    motif.lines.push_back(std::move(line));
  }
  return motif;
}

Motif motif_of(const std::vector<std::vector<Vec2>>& lines) {
  Motif motif;
  for (const std::vector<Vec2>& points : lines) {
    if (points.size() < 2) continue;
    motif.lines.push_back({points, false});
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      motif.length += glm::distance(points[i], points[i + 1]);
    }
  }
  return motif;
}

Motif motif_of(const HatchOptions& options, const std::string& group, double tolerance) {
  try {
    return make_motif(options.motif, tolerance);
  } catch (const UsageError& e) {
    throw UsageError(fmt::format("style key '{}motif': {}", group, e.what()));
  }
}

}  // namespace burin::detail
