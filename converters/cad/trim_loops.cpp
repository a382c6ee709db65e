#include "trim_loops.h"

#include <burin/base/error.h>
#include <burin/base/nearest_along.h>
#include <burin/planar/even_odd.h>

#include "closed_loop.h"

#include <fmt/format.h>

#include <algorithm>

namespace burin {
namespace {

/// Loops are compared in pairs.
constexpr std::size_t kMostLoops = 1000;
constexpr std::size_t kMostSamples = 200'000;
/// Edges of one face: OCCT compares their ends in pairs.
constexpr std::size_t kMostEdges = 5000;

/// The ray of +x from p meets the polygon an odd number of times.
bool within(const std::vector<Vec2>& polygon, Vec2 p) {
  bool odd = false;
  for (std::size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++) {
    if (crosses_ray(polygon[i], polygon[k], p)) odd = !odd;
  }
  return odd;
}

double distance_to(const std::vector<Vec2>& polygon, Vec2 p) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++) {
    best = std::min(best, distance_to_segment(polygon[k], polygon[i], p));
  }
  return best;
}

class Nesting {
 public:
  Nesting(std::vector<ClosedLoop> loops, const std::string& file, const RunContext& context)
      : loops_(std::move(loops)), file_(file), context_(context) {}
  std::vector<TrimRegion> regions();

 private:
  bool lies_in(const ClosedLoop& inner, const ClosedLoop& outer) const;

  std::vector<ClosedLoop> loops_;
  const std::string& file_;
  const RunContext& context_;
};

bool Nesting::lies_in(const ClosedLoop& inner, const ClosedLoop& outer) const {
  const bool apart = glm::any(glm::greaterThan(inner.min, outer.max)) ||
                     glm::any(glm::lessThan(inner.max, outer.min));
  if (apart) return false;
  // Loops may touch; nearer than this a polygon does not tell the sides of its curves.
  const double near = 1e-3 * glm::distance(outer.min, outer.max);
  constexpr std::size_t kTests = 64;
  const std::size_t step = std::max<std::size_t>(1, inner.polygon.size() / kTests);
  std::size_t in = 0, out = 0, tests = 0, all_in = 0;
  for (std::size_t i = 0; i < inner.polygon.size(); i += step) {
    const Vec2 p = inner.polygon[i];
    const bool inside = within(outer.polygon, p);
    ++tests;
    all_in += inside ? 1 : 0;
    // Only where it counts: the distance costs more.
    if (((inside ? in : out) > 0) || distance_to(outer.polygon, p) < near) continue;
    ++(inside ? in : out);
  }
  if (in > 0 && out > 0) {
    fail_at(file_, inner.place,
            fmt::format("this trimming loop crosses the one of line {}; part them, or make the "
                        "trimmed surface again",
                        outer.place.line));
  }
  // All along each other: most points decide.
  return in + out > 0 ? in > 0 : 2 * all_in > tests;
}

std::vector<TrimRegion> Nesting::regions() {
  const std::size_t n = loops_.size();
  std::vector<std::vector<std::size_t>> around(n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      context_.check();
      if (i != k && lies_in(loops_[i], loops_[k])) around[i].push_back(k);
    }
  }
  std::vector<TrimRegion> regions;
  std::vector<std::size_t> region_of(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (around[i].size() % 2 == 1) continue;
    region_of[i] = regions.size();
    loops_[i].turn(true);
    regions.push_back({loops_[i].curves, {}});
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (around[i].size() % 2 == 0) continue;
    const auto parent = std::ranges::find_if(
        around[i], [&](std::size_t k) { return around[k].size() + 1 == around[i].size(); });
    if (parent == around[i].end()) {
      fail_at(file_, loops_[i].place,
              "this trimming loop lies in others that cross; make the trimmed surface again");
    }
    loops_[i].turn(false);
    regions[region_of[*parent]].holes.push_back(loops_[i].curves);
  }
  return regions;
}

}  // namespace

std::vector<TrimRegion> trim_regions(const TrimmedSurface& trimmed, const std::string& file,
                                     const RunContext& context) {
  if (trimmed.loops.size() > kMostLoops) {
    fail_at(file, trimmed.place,
            fmt::format("{} trimming loops; at most {} are read, split the surface",
                        trimmed.loops.size(), kMostLoops));
  }
  const NurbsData& s = trimmed.surface;
  const auto knot = [](const std::vector<double>& knots, int i) {
    return knots[static_cast<std::size_t>(i)];
  };
  const LoopDomain domain{{knot(s.knots_u, s.degree_u), knot(s.knots_v, s.degree_v)},
                          {knot(s.knots_u, s.count_u), knot(s.knots_v, s.count_v)}};
  std::vector<ClosedLoop> loops;
  std::size_t samples = 0, edges = 0;
  for (const TrimLoop& loop : trimmed.loops) {
    context.check();
    try {
      loops.push_back(close_loop(loop, domain));
    } catch (const GeometryError& e) {
      fail_at(file, loop.place, fmt::format("this trimming loop cannot be read: {}", e.what()));
    }
    samples += loops.back().polygon.size();
    edges += loops.back().curves.size();
    if (samples > kMostSamples || edges > kMostEdges) {
      fail_at(file, loop.place,
              "the trimming loops up to this one have too many points; split the surface");
    }
  }
  return Nesting(std::move(loops), file, context).regions();
}

}  // namespace burin
