#include <burin/work_mesh/half_edges.h>

#include <algorithm>

namespace burin {

std::vector<HalfEdge> pair_half_edges(const std::vector<Triangle>& triangles,
                                      std::size_t vertex_count) {
  const std::size_t n = 3 * triangles.size();
  struct End {
    std::uint32_t high;
    HalfEdge h;
  };
  const auto from = [&](std::size_t h) { return triangles[h / 3][h % 3]; };
  const auto to = [&](std::size_t h) { return triangles[h / 3][(h + 1) % 3]; };
  // Half-edges by the lower of their ends (a counting sort), there by the higher.
  std::vector<std::uint32_t> start(vertex_count + 2, 0);
  for (std::size_t h = 0; h < n; ++h) ++start[std::min(from(h), to(h)) + 2];
  for (std::size_t v = 2; v < start.size(); ++v) start[v] += start[v - 1];
  std::vector<End> ends(n);
  for (std::size_t h = 0; h < n; ++h) {
    const std::uint32_t low = std::min(from(h), to(h)), high = std::max(from(h), to(h));
    ends[start[low + 1]++] = {high, static_cast<HalfEdge>(h)};
  }
  std::vector<HalfEdge> opposite(n, kNoHalfEdge);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto begin = ends.begin() + start[v], end = ends.begin() + start[v + 1];
    std::sort(begin, end, [](const End& a, const End& b) {
      return a.high != b.high ? a.high < b.high : a.h < b.h;
    });
    for (auto i = begin; i != end;) {
      auto j = i;
      while (j != end && j->high == i->high) ++j;
      const auto a = static_cast<std::size_t>(i->h);
      if (j - i == 2 && from(a) != from(static_cast<std::size_t>(i[1].h))) {
        opposite[a] = i[1].h;
        opposite[static_cast<std::size_t>(i[1].h)] = i->h;
      }
      i = j;
    }
  }
  return opposite;
}

}  // namespace burin
