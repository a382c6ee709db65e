#include <burin/base/groups.h>
#include <burin/work_mesh/half_edges.h>

#include <algorithm>
#include <array>

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
  // Half-edges by the lower of their ends and there by the higher.
  auto ends = grouped(
      vertex_count, n, [&](std::size_t h) { return std::array{std::min(from(h), to(h))}; },
      [&](std::size_t h) {
        return std::array{End{std::max(from(h), to(h)), static_cast<HalfEdge>(h)}};
      });
  std::vector<HalfEdge> opposite(n, kNoHalfEdge);
  for (std::size_t v = 0; v < vertex_count; ++v) {
    const auto begin = ends.list.begin() + ends.first[v],
               end = ends.list.begin() + ends.first[v + 1];
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
