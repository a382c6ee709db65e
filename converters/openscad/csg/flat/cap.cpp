#include "cap.h"

#include <burin/base/disjoint_sets.h>
#include <burin/planar/triangulate.h>

#include "origins.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace burin::csg {
namespace {

using HalfEdges = std::unordered_map<std::uint64_t, std::uint32_t>;

std::uint64_t key(std::uint32_t from, std::uint32_t to) {
  return (static_cast<std::uint64_t>(from) << 32) | to;
}

/// For each point the first one at the same place, as the triangulation names it.
std::vector<std::uint32_t> first_at_place(const std::vector<Vec2>& points) {
  std::vector<std::uint32_t> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec2 &p = points[a], &q = points[b];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && points[order[i]] == points[order[i - 1]];
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  return first;
}

struct Outlines {
  std::vector<Vec2> points;
  std::vector<DirectedEdge> edges;
  std::unordered_map<std::uint64_t, Cap::Edge> known;
};

Outlines collect(const Region& region) {
  Outlines out;
  for (const Outline& o : region.outlines)
    out.points.insert(out.points.end(), o.points.begin(), o.points.end());
  const std::vector<std::uint32_t> first = first_at_place(out.points);
  std::uint32_t begin = 0;
  for (const Outline& o : region.outlines) {
    const auto n = static_cast<std::uint32_t>(o.points.size());
    const bool hole = doubled_area(o) < 0;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = first[begin + i], b = first[begin + (i + 1) % n];
      out.edges.push_back({begin + i, begin + (i + 1) % n});
      out.known.try_emplace(key(a, b), Cap::Edge{a, b, o.arc[i], hole});
    }
    begin += n;
  }
  return out;
}

HalfEdges half_edges(const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  HalfEdges out;
  out.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      out.emplace(key(triangles[t][k], triangles[t][(k + 1) % 3]), 3 * t + k);
    }
  }
  return out;
}

}  // namespace

Cap cap_of(const Region& region) {
  Cap cap;
  const Outlines outlines = collect(region);
  const Triangulated inside = triangulate(outlines.points, outlines.edges);
  const HalfEdges edges = half_edges(inside.triangles);
  const auto count = static_cast<std::uint32_t>(inside.triangles.size());
  const auto next = [](std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; };
  const auto point_of = [&](std::uint32_t corner) {
    return inside.triangles[corner / 3][corner % 3];
  };
  const auto other_side = [&](std::uint32_t corner) {
    return edges.find(key(point_of(next(corner)), point_of(corner)));
  };
  // Corners at one point belong together as far as triangles lie beside each other.
  DisjointSets corners(3 * count);
  for (std::uint32_t c = 0; c < 3 * count; ++c) {
    const auto other = other_side(c);
    if (other == edges.end()) continue;
    corners.join(c, next(other->second));
    corners.join(next(c), other->second);
  }
  std::vector<std::uint32_t> vertex(3 * count);
  for (std::uint32_t c = 0; c < 3 * count; ++c) {
    const std::uint32_t set = corners.find(c);
    if (set == c) {
      const std::uint32_t p = point_of(c);
      vertex[c] = static_cast<std::uint32_t>(cap.points.size());
      cap.points.push_back(p < outlines.points.size() ? outlines.points[p]
                                                      : inside.added[p - outlines.points.size()]);
    } else {
      vertex[c] = vertex[set];
    }
  }
  for (std::uint32_t t = 0; t < count; ++t) {
    cap.triangles.push_back({vertex[3 * t], vertex[3 * t + 1], vertex[3 * t + 2]});
  }
  for (std::uint32_t c = 0; c < 3 * count; ++c) {
    if (other_side(c) != edges.end()) continue;
    const auto known = outlines.known.find(key(point_of(c), point_of(next(c))));
    Cap::Edge edge = known == outlines.known.end() ? Cap::Edge{} : known->second;
    edge.from = vertex[c];
    edge.to = vertex[next(c)];
    cap.rim.push_back(edge);
  }
  return cap;
}

}  // namespace burin::csg
