#include "show.h"

#include <burin/explode/seen.h>

#include <algorithm>
#include <set>

namespace burin::detail {
namespace {

/// The least share of a silhouette of what moves that is seen from somewhere; those that stand
/// before what is seen less than it should be go to `before`.
double least_seen(const PartsInSight& sight, const BuildStep& step, Vec3 direction, Vec3 up,
                  std::set<std::size_t>* before) {
  double least = 1;
  for (const BuildMove& move : step.moves) {
    std::set<std::size_t> others;
    const double share = sight.seen(move.parts, direction, up, &others);
    least = std::min(least, share);
    if (before && share < kLeastSeen) before->insert(others.begin(), others.end());
  }
  return least;
}

}  // namespace

Look best_look(std::span<const ProxyMesh* const> proxies, const BuildStep& step,
               const std::vector<Vec3>& moved, const ViewOptions& asked,
               const RunContext& context) {
  const Camera camera = Camera::fit(
      [](const Mat3&) {
        return Box3{Vec3(-1), Vec3(1)};
      },
      {.direction = asked.direction, .up = asked.up});
  Look first{camera.direction(), camera.up(), {}};
  if (step.moves.empty()) return first;
  const PartsInSight sight(proxies, step.parts(), moved, context);
  Look best = first;
  double most = least_seen(sight, step, first.direction, first.up, nullptr);
  for (const Vec3& d : corners_about(first.direction)) {
    if (most >= kLeastSeen) break;
    context.check();
    const double seen = least_seen(sight, step, d, Vec3(0, 0, 1), nullptr);
    if (seen > most) most = seen, best = {d, Vec3(0, 0, 1), {}};
  }
  if (most >= kLeastSeen) return best;
  std::set<std::size_t> before;
  least_seen(sight, step, best.direction, best.up, &before);
  for (const std::size_t part : before) {
    if (std::ranges::binary_search(step.assembled, part)) best.ghosts.push_back(part);
  }
  return best;
}

}  // namespace burin::detail
