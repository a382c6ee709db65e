#include "stages.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace burin::repair_stages {
namespace {

// Radians within which triangles around an edge count as coincident: the rounding of single
// precision.
constexpr double kSameAngle = 1e-6;

struct Leaf {  // one triangle at an edge
  std::uint32_t half_edge;
  double angle;
  bool forward;  // runs from the edge's lower vertex to the higher one
};

/// The triangles at an edge in the order of their angles, counter-clockwise seen against the edge's
/// direction. Of coincident ones the forward come first, which end material, before those that
/// begin it.
std::vector<Leaf> sorted_around(const TriMesh& mesh, std::span<const std::uint32_t> group) {
  const std::uint32_t u = std::min(from(mesh, group[0]), to(mesh, group[0]));
  const std::uint32_t v = std::max(from(mesh, group[0]), to(mesh, group[0]));
  const Vec3 origin = mesh.positions[u];
  const Vec3 axis = normalize_or(mesh.positions[v] - origin, Vec3(0, 0, 1));
  const Vec3 x = normalize_or(reject(mesh.positions[apex(mesh, group[0])] - origin, axis),
                              any_orthogonal(axis));
  const Vec3 y = glm::cross(axis, x);
  std::vector<Leaf> leaves;
  for (const std::uint32_t h : group) {
    const Vec3 d = mesh.positions[apex(mesh, h)] - origin;
    double angle = std::atan2(glm::dot(d, y), glm::dot(d, x));
    if (angle < -kSameAngle) angle += 2 * std::numbers::pi;
    leaves.push_back({h, angle, from(mesh, h) == u});
  }
  std::ranges::stable_sort(leaves, {}, &Leaf::angle);
  for (auto begin = leaves.begin(); begin != leaves.end();) {
    const double limit = begin->angle + kSameAngle;
    const auto end =
        std::find_if(begin, leaves.end(), [&](const Leaf& l) { return l.angle > limit; });
    std::stable_partition(begin, end, [](const Leaf& l) { return l.forward; });
    begin = end;
  }
  return leaves;
}

void pair(std::vector<std::uint32_t>& opposite, const Leaf& a, const Leaf& b) {
  opposite[a.half_edge] = b.half_edge;
  opposite[b.half_edge] = a.half_edge;
}

/// As many begin material as end it: pairs like brackets on a circle.
void pair_solids(std::vector<Leaf> leaves, std::vector<std::uint32_t>& opposite) {
  std::size_t i = 0;
  while (leaves.size() >= 2) {
    i %= leaves.size();
    const std::size_t next = (i + 1) % leaves.size();
    if (leaves[i].forward || !leaves[next].forward) {
      ++i;
      continue;
    }
    pair(opposite, leaves[i], leaves[next]);
    leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(std::max(i, next)));
    leaves.erase(leaves.begin() + static_cast<std::ptrdiff_t>(std::min(i, next)));
    if (i > 0) --i;
  }
}

/// Sheets that meet: those go on into each other that do so most smoothly; the rest end here.
void pair_sheets(const std::vector<Leaf>& leaves, std::vector<std::uint32_t>& opposite) {
  struct Candidate {
    double bend;
    std::size_t forward, backward;
  };
  std::vector<Candidate> candidates;
  for (std::size_t f = 0; f < leaves.size(); ++f) {
    for (std::size_t b = 0; b < leaves.size(); ++b) {
      if (!leaves[f].forward || leaves[b].forward) continue;
      const double between = std::abs(leaves[f].angle - leaves[b].angle);
      candidates.push_back({std::abs(between - std::numbers::pi), f, b});
    }
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::bend);
  for (const Candidate& c : candidates) {
    const Leaf &f = leaves[c.forward], &b = leaves[c.backward];
    if (opposite[f.half_edge] == kNone && opposite[b.half_edge] == kNone) pair(opposite, f, b);
  }
}

}  // namespace

std::vector<std::uint32_t> match_half_edges(const TriMesh& mesh, const EdgeGroups& edges, bool cut,
                                            RepairCounts& counts) {
  std::vector<std::uint32_t> opposite(edges.half_edge.size(), kNone);
  for (std::size_t g = 0; g < edges.size(); ++g) {
    const auto group = edges[g];
    if (group.size() == 2 && from(mesh, group[0]) != from(mesh, group[1])) {
      opposite[group[0]] = group[1];
      opposite[group[1]] = group[0];
    }
    if (group.size() <= 2) continue;
    ++counts.nonmanifold_edges;
    if (cut) continue;
    // Thousands of triangles at one edge are no shape, and comparing all of them would take
    // forever.
    constexpr std::size_t kMostSolids = 4096, kMostSheets = 256;
    if (group.size() > kMostSolids) continue;
    std::vector<Leaf> leaves = sorted_around(mesh, group);
    const auto forward = static_cast<std::size_t>(std::ranges::count_if(leaves, &Leaf::forward));
    if (2 * forward == leaves.size()) {
      pair_solids(std::move(leaves), opposite);
    } else if (leaves.size() <= kMostSheets) {
      pair_sheets(leaves, opposite);
    }
  }
  return opposite;
}

}  // namespace burin::repair_stages
