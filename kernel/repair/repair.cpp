#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/repair/repair.h>
#include <burin/repair/weld.h>

#include "stages.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace burin {
namespace {

using namespace repair_stages;

constexpr std::size_t kCornerGrain = 65536;

// Squares of squares of larger coordinates leave the range of double.
constexpr double kLargestCoordinate = 1e60;
// A point farther from the middle than this many times the usual distance is garbage: were it kept,
// the rest of the model would be smaller on paper than an atom.
constexpr double kWildRatio = 1e9;

bool usable(const Vec3& p) {
  return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate &&
         std::abs(p.z) <= kLargestCoordinate;  // false for NaN
}

template <class Predicate>
bool any_position(const TriMesh& mesh, const RunContext& context, const Predicate& predicate) {
  std::atomic<bool> found{false};
  parallel_for(
      mesh.positions.size(), kCornerGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          if (predicate(mesh.positions[i])) {
            found.store(true, std::memory_order_relaxed);
            return;
          }
        }
      },
      &context);
  return found;
}

/// Removes the triangles at the positions that `bad` picks.
template <class Predicate>
std::int64_t drop_triangles_at(TriMesh& mesh, Numbers* of, const Predicate& bad) {
  std::vector<std::uint8_t> is_bad(mesh.positions.size());
  for (std::size_t i = 0; i < is_bad.size(); ++i) is_bad[i] = bad(mesh.positions[i]);
  return erase_triangles(
      mesh, of, [&](const Triangle& t) { return is_bad[t[0]] || is_bad[t[1]] || is_bad[t[2]]; });
}

void drop_unusable(TriMesh& mesh, Numbers* of, Diagnostics& diagnostics,
                   const RunContext& context) {
  const auto bad = [](const Vec3& p) { return !usable(p); };
  if (!any_position(mesh, context, bad)) return;
  const std::int64_t dropped = drop_triangles_at(mesh, of, bad);
  if (dropped == 0) return;
  diagnostics.add(Severity::Warning, "mesh.bad_coordinates", dropped,
                  "triangles with NaN, infinite or absurd coordinates were left out");
}

/// Where most of the points are: the median of each coordinate, and the median distance from there.
std::pair<Vec3, double> middle_of(const std::vector<Vec3>& points) {
  constexpr std::size_t kSamples = 4001;
  std::vector<Vec3> sample;
  const std::size_t step = points.size() / kSamples + 1;
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (usable(points[i])) sample.push_back(points[i]);
  }
  if (sample.empty()) return {Vec3(0), 0};
  const auto median = [&](const auto& value) {
    std::vector<double> values;
    for (const Vec3& p : sample) values.push_back(value(p));
    const auto mid = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), mid, values.end());
    return *mid;
  };
  const Vec3 center(median([](const Vec3& p) { return p.x; }),
                    median([](const Vec3& p) { return p.y; }),
                    median([](const Vec3& p) { return p.z; }));
  return {center, median([&](const Vec3& p) { return glm::length(p - center); })};
}

void drop_wild(TriMesh& mesh, Numbers* of, Diagnostics& diagnostics, const RunContext& context) {
  const auto [center, distance] = middle_of(mesh.positions);
  if (!(distance > 0)) return;
  const auto bad = [c = center, limit = kWildRatio * distance](const Vec3& p) {
    return !(glm::length(p - c) <= limit);
  };
  if (!any_position(mesh, context, bad)) return;
  const std::int64_t dropped = drop_triangles_at(mesh, of, bad);
  if (dropped == 0) return;
  diagnostics.add(
      Severity::Warning, "mesh.wild_coordinates", dropped,
      "triangles with a corner a billion times farther out than the rest were left out");
}

void merge_points(TriMesh& mesh, const RunContext& context) {
  const Weld w = weld(mesh.positions, context);
  if (w.first.size() == mesh.positions.size()) return;
  for (std::size_t i = 0; i < w.first.size(); ++i) mesh.positions[i] = mesh.positions[w.first[i]];
  mesh.positions.resize(w.first.size());
  parallel_for(mesh.triangles.size(), kCornerGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (std::uint32_t& v : mesh.triangles[t]) v = w.vertex[v];
    }
  });
}

void require_triangles(const TriMesh& mesh) {
  if (mesh.triangles.empty()) {
    throw GeometryError("no triangle with an area is left after repair; export the model again");
  }
}

}  // namespace

TriMesh repair(PolygonSoup soup, const RepairOptions& options, Diagnostics& diagnostics,
               const RunContext& context, Numbers* of) {
  TriMesh mesh = triangulate(std::move(soup), of, diagnostics, context);
  drop_unusable(mesh, of, diagnostics, context);
  drop_wild(mesh, of, diagnostics, context);
  if (options.merge_duplicate_points) merge_points(mesh, context);
  require_triangles(mesh);
  drop_unused_positions(mesh);
  Cleanness found = inspect(mesh, context);
  if (!found.clean()) {
    make_manifold(mesh, of, diagnostics, context);
    require_triangles(mesh);
    found = inspect(mesh, context);
  }
  orient_outwards(mesh, found.open, diagnostics, context);
  if (found.boundary_edges > 0) {
    diagnostics.add(Severity::Info, "mesh.open", found.boundary_edges,
                    "edges at which the surface ends; it encloses no solid there");
  }
  return mesh;
}

}  // namespace burin
