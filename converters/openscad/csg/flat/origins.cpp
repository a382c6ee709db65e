#include "origins.h"

#include <burin/base/error.h>

#include "clip.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace burin::csg {
namespace {

// Clipper holds 2^62 grid units; squares of these still fit into its 128 bits.
constexpr double kFarthest = 1e12;
// mm: a cut point is rounded by less than one unit in each direction, and its edge too.
constexpr double kOriginSlack = 2.0 / kGrid;

std::size_t mixed(std::uint64_t a, std::uint64_t b) {
  std::uint64_t h = a * 0x9e3779b97f4a7c15u + b;
  h ^= h >> 29;
  h *= 0xbf58476d1ce4e5b9u;
  return h ^ (h >> 32);
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double t =
      glm::dot(d, d) > 0 ? std::clamp(glm::dot(p - a, d) / glm::dot(d, d), 0.0, 1.0) : 0.0;
  return glm::length(p - a - t * d);
}

std::int64_t cell_of(double v, double size) {
  return static_cast<std::int64_t>(std::floor(v / size));
}

}  // namespace

std::size_t GridPointHash::operator()(const GridPoint& p) const {
  return mixed(static_cast<std::uint64_t>(p.x), static_cast<std::uint64_t>(p.y));
}

std::size_t Origins::CellHash::operator()(const Cell& c) const {
  return mixed(mixed(static_cast<std::uint64_t>(c.x), static_cast<std::uint64_t>(c.y)),
               static_cast<std::uint64_t>(c.level));
}

GridPoint on_grid(Vec2 p) {
  if (!(std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest)) {
    throw InputError("a 2-D point is no number or beyond 1e12 mm; check the units of the model");
  }
  return {static_cast<std::int64_t>(p.x * kGrid), static_cast<std::int64_t>(p.y * kGrid)};
}

Vec2 off_grid(GridPoint p) {
  return {static_cast<double>(p.x) / kGrid, static_cast<double>(p.y) / kGrid};
}

void Origins::add(const Region& region) {
  for (const Outline& o : region.outlines) {
    for (std::size_t i = 0; i < o.points.size(); ++i) {
      add_point(o.points[i]);
      if (o.arc[i] < 0) continue;
      add_edge(o.points[i], o.points[(i + 1) % o.points.size()],
               region.arcs[static_cast<std::size_t>(o.arc[i])]);
    }
  }
}

void Origins::add_edge(Vec2 a, Vec2 b, const Arc& arc) {
  const double length = glm::length(b - a);
  if (!(length > 0)) return;
  // Edges of one arc come one behind the other.
  const auto same = [&](const Arc& other) {
    return other.middle == arc.middle && other.radius == arc.radius && other.step == arc.step;
  };
  if (arcs_.empty() || !same(arcs_.back())) arcs_.push_back(arc);
  const int level = static_cast<int>(std::ceil(std::log2(length)));
  const double size = std::ldexp(1.0, level);
  levels_.emplace(level, size);
  const auto edge = static_cast<std::uint32_t>(edges_.size());
  edges_.push_back({a, b, static_cast<std::uint32_t>(arcs_.size() - 1)});
  const Vec2 low = glm::min(a, b) - kOriginSlack, high = glm::max(a, b) + kOriginSlack;
  for (std::int64_t x = cell_of(low.x, size); x <= cell_of(high.x, size); ++x) {
    for (std::int64_t y = cell_of(low.y, size); y <= cell_of(high.y, size); ++y) {
      cells_[{level, x, y}].push_back(edge);
    }
  }
}

Vec2 Origins::point(GridPoint p) const {
  const auto found = points_.find(p);
  return found == points_.end() ? off_grid(p) : found->second;
}

std::int64_t Origins::arc_on(Vec2 a, Vec2 b) const {
  const Vec2 middle = 0.5 * (a + b);
  for (const auto& [level, size] : levels_) {
    const auto cell = cells_.find({level, cell_of(middle.x, size), cell_of(middle.y, size)});
    if (cell == cells_.end()) continue;
    for (const std::uint32_t edge : cell->second) {
      const Edge& e = edges_[edge];
      if (distance_to_segment(a, e.a, e.b) <= kOriginSlack &&
          distance_to_segment(b, e.a, e.b) <= kOriginSlack)
        return e.arc;
    }
  }
  return -1;
}

void Origins::tag(Region& result) const {
  const auto first = static_cast<std::int32_t>(result.arcs.size());
  result.arcs.insert(result.arcs.end(), arcs_.begin(), arcs_.end());
  for (Outline& o : result.outlines) {
    o.arc.resize(o.points.size(), -1);
    for (std::size_t i = 0; i < o.points.size(); ++i) {
      if (o.arc[i] >= 0) continue;
      const std::int64_t arc = arc_on(o.points[i], o.points[(i + 1) % o.points.size()]);
      if (arc >= 0) o.arc[i] = first + static_cast<std::int32_t>(arc);
    }
  }
  tidy_arcs(result);
}

void tidy_arcs(Region& region) {
  std::map<std::tuple<double, double, double, double>, std::int32_t> place;
  std::vector<Arc> arcs;
  for (Outline& o : region.outlines) {
    for (std::int32_t& arc : o.arc) {
      if (arc < 0) continue;
      const Arc& a = region.arcs[static_cast<std::size_t>(arc)];
      const auto [at, is_new] = place.try_emplace({a.middle.x, a.middle.y, a.radius, a.step},
                                                  static_cast<std::int32_t>(arcs.size()));
      if (is_new) arcs.push_back(a);
      arc = at->second;
    }
  }
  region.arcs = std::move(arcs);
}

Outline reversed(const Outline& outline) {
  const std::size_t n = outline.points.size();
  Outline out;
  for (std::size_t i = 0; i < n; ++i) {
    out.points.push_back(outline.points[n - 1 - i]);
    out.arc.push_back(outline.arc[(2 * n - 2 - i) % n]);
  }
  return out;
}

double doubled_area(const Outline& outline) {
  double sum = 0;
  const std::size_t n = outline.points.size();
  // About the first point, so that far outlines lose no digits.
  for (std::size_t i = 0; i < n; ++i) {
    sum += cross2(outline.points[i] - outline.points[0],
                  outline.points[(i + 1) % n] - outline.points[0]);
  }
  return sum;
}

double area(const Region& region) {
  double sum = 0;
  for (const Outline& o : region.outlines) sum += doubled_area(o) / 2;
  return sum;
}

}  // namespace burin::csg
