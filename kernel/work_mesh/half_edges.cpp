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

std::array<FlippedSide, 6> flip_edge(std::vector<Triangle>& triangles,
                                     std::vector<HalfEdge>& opposite, HalfEdge h) {
  const auto index = [](HalfEdge x) { return static_cast<std::size_t>(x); };
  const auto from = [&](HalfEdge x) { return triangles[face_of(x)][index(x) % 3]; };
  const HalfEdge o = opposite[index(h)], n = next_in_face(h), p = prev_in_face(h);
  const HalfEdge m = next_in_face(o), q = prev_in_face(o);
  const std::uint32_t s = face_of(h), t = face_of(o);
  const auto f = static_cast<HalfEdge>(3 * s), g = static_cast<HalfEdge>(3 * t);
  const std::array<FlippedSide, 6> sides{{{f, m, h},
                                          {f + 1, kNoHalfEdge, q},
                                          {f + 2, p, p},
                                          {g, q, q},
                                          {g + 1, n, n},
                                          {g + 2, kNoHalfEdge, p}}};
  std::array<HalfEdge, 6> beyond{};
  for (std::size_t k = 0; k < 6; ++k) {
    beyond[k] =
        sides[k].side == kNoHalfEdge ? (k == 1 ? g + 2 : f + 1) : opposite[index(sides[k].side)];
  }
  const std::uint32_t a = from(h), b = from(n), c = from(p), d = from(q);
  triangles[s] = {a, d, c};
  triangles[t] = {d, b, c};
  for (std::size_t k = 0; k < 6; ++k) {
    opposite[index(sides[k].at)] = beyond[k];
    if (beyond[k] != kNoHalfEdge) opposite[index(beyond[k])] = sides[k].at;
  }
  return sides;
}

}  // namespace burin
