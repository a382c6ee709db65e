#include <burin/base/parallel.h>

#include "stages.h"

#include <algorithm>

namespace burin::repair_stages {

EdgeGroups group_edges(const TriMesh& mesh, const RunContext& context) {
  const auto low = [&](std::uint32_t h) { return std::min(from(mesh, h), to(mesh, h)); };
  const auto high = [&](std::uint32_t h) { return std::max(from(mesh, h), to(mesh, h)); };
  const auto count = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  // Dealt to their lower vertices by counting, then sorted in these small heaps.
  std::vector<std::uint32_t> start(mesh.positions.size() + 1, 0);
  for (std::uint32_t h = 0; h < count; ++h) ++start[low(h)];
  std::uint32_t sum = 0;
  for (std::uint32_t& s : start) s = sum += s;
  EdgeGroups groups;
  groups.half_edge.resize(count);
  for (std::uint32_t h = count; h-- > 0;) groups.half_edge[--start[low(h)]] = h;
  parallel_for(
      mesh.positions.size(), 16384,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          std::sort(groups.half_edge.begin() + start[v], groups.half_edge.begin() + start[v + 1],
                    [&](std::uint32_t g, std::uint32_t h) {
                      const std::uint32_t a = high(g), b = high(h);
                      return a != b ? a < b : g < h;
                    });
        }
      },
      &context);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t h = groups.half_edge[i];
    const bool goes_on =
        i > 0 && low(groups.half_edge[i - 1]) == low(h) && high(groups.half_edge[i - 1]) == high(h);
    if (!goes_on) groups.start.push_back(i);
  }
  groups.start.push_back(count);
  return groups;
}

}  // namespace burin::repair_stages
