#include "stages.h"

#include <algorithm>
#include <numeric>

namespace burin::repair_stages {
namespace {

/// For each half-edge of an edge of exactly two triangles the other one.
std::vector<std::uint32_t> mates(const EdgeGroups& edges) {
  std::vector<std::uint32_t> mate(edges.half_edge.size(), kNone);
  for (std::size_t g = 0; g < edges.size(); ++g) {
    const auto group = edges[g];
    if (group.size() != 2) continue;
    mate[group[0]] = group[1];
    mate[group[1]] = group[0];
  }
  return mate;
}

/// Turns a whole patch over where most of it was turned.
void keep_majority(const std::vector<std::uint32_t>& patch, std::vector<std::uint8_t>& turned) {
  std::size_t count = 0;
  for (const std::uint32_t t : patch) count += turned[t];
  if (2 * count <= patch.size()) return;
  for (const std::uint32_t t : patch) turned[t] ^= 1;
}

}  // namespace

void orient_patches(TriMesh& mesh, EdgeGroups& edges, RepairCounts& counts,
                    const RunContext& context) {
  const std::vector<std::uint32_t> mate = mates(edges);
  const auto n = static_cast<std::uint32_t>(mesh.triangles.size());
  std::vector<std::uint8_t> turned(n, 0), seen(n, 0);
  std::vector<std::uint32_t> patch;
  for (std::uint32_t first = 0; first < n; ++first) {
    if (seen[first]) continue;
    context.check();
    patch.assign(1, first);
    seen[first] = 1;
    for (std::size_t i = 0; i < patch.size();
         ++i) {  // breadth first: cuts, where needed, stay short
      const std::uint32_t t = patch[i];
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (mate[h] == kNone || seen[mate[h] / 3]) continue;
        const std::uint32_t other = mate[h] / 3;
        const bool same_way = from(mesh, h) == from(mesh, mate[h]);
        turned[other] = turned[t] ^ static_cast<std::uint8_t>(same_way);
        seen[other] = 1;
        patch.push_back(other);
      }
    }
    keep_majority(patch, turned);
  }

  for (std::uint32_t h = 0; h < mate.size(); ++h) {
    if (mate[h] == kNone || mate[h] < h) continue;
    const bool same_way = from(mesh, h) == from(mesh, mate[h]);
    counts.nonorientable_edges += same_way != (turned[h / 3] != turned[mate[h] / 3]);
  }
  counts.flipped += std::accumulate(turned.begin(), turned.end(), std::int64_t{0});
  for (std::uint32_t t = 0; t < n; ++t) {
    if (turned[t]) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  for (std::uint32_t& h : edges.half_edge) {
    if (turned[h / 3]) h = h / 3 * 3 + (2 - h % 3);
  }
}

}  // namespace burin::repair_stages
