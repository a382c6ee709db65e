#include <burin/base/error.h>

#include "boolean.h"
#include "triangulate.h"

#include <algorithm>
#include <map>
#include <unordered_map>

namespace burin::csg {
namespace {

std::uint64_t key(Id a, Id b) { return (std::uint64_t{std::min(a, b)} << 32) | std::max(a, b); }

/// The one line and the two ends of the edges at a point, as long as there are no more.
struct Passage {
  Id line = kNone;
  std::array<Id, 2> ends{kNone, kNone};
  bool straight = true;

  void add(Id l, Id end) {
    if (line == kNone) line = l;
    if (l != line) straight = false;
    if (ends[0] == end || ends[1] == end) return;
    if (ends[0] == kNone) {
      ends[0] = end;
    } else if (ends[1] == kNone) {
      ends[1] = end;
    } else {
      straight = false;
    }
  }
};

/// Every edge takes the line of the two planes that it separates, the same from both.
void name_lines(Space& space, Mesh& mesh) {
  std::unordered_map<std::uint64_t, std::array<Id, 2>> planes;
  for (const Facet& f : mesh.facets) {
    for (const Edge& e : f.edges) {
      auto& pair = planes.try_emplace(key(e.a, e.b), std::array<Id, 2>{kNone, kNone}).first->second;
      if (pair[0] == kNone) {
        pair[0] = f.plane;
      } else if (pair[0] != f.plane && pair[1] == kNone) {
        pair[1] = f.plane;
      }
    }
  }
  for (Facet& f : mesh.facets) {
    for (Edge& e : f.edges) {
      const auto& pair = planes.at(key(e.a, e.b));
      if (pair[1] == kNone) continue;
      const Id line = space.find_line(pair[0], pair[1]);
      if (line != kNone) e.line = line;
    }
  }
}

void leave_out_passages(Facet& facet, const std::unordered_map<Id, Passage>& at) {
  const auto passes = [&](Id p) { return at.at(p).straight; };
  std::unordered_map<Id, std::size_t> next;
  for (std::size_t k = 0; k < facet.edges.size(); ++k) {
    if (passes(facet.edges[k].a)) next[facet.edges[k].a] = k;
  }
  if (next.empty()) return;
  std::vector<Edge> out;
  for (const Edge& first : facet.edges) {
    if (passes(first.a)) continue;
    Edge e = first;
    while (passes(e.b)) e.b = facet.edges[next.at(e.b)].b;
    out.push_back(e);
  }
  facet.edges = std::move(out);
}

/// Triangles of a facet, counter-clockwise from outside.
void fill(Space& space, const Facet& facet, std::vector<std::array<Id, 3>>& out) {
  const auto& edges = facet.edges;
  if (edges.size() == 3) {
    const Id third = edges[1].a == edges[0].b ? edges[1].b : edges[2].b;
    out.push_back({edges[0].a, edges[0].b, third});
    return;
  }
  std::vector<std::array<Id, 2>> pairs;
  for (const Edge& e : edges) pairs.push_back({e.a, e.b});
  const Triangulation net = triangulate(space, facet.plane, pairs);
  // An even number of edges to the outside of all: not of the facet.
  std::vector<char> parity(net.triangles.size(), -1);
  std::vector<std::uint32_t> open;
  const auto reach = [&](std::uint32_t t, int p) {
    if (parity[t] >= 0) return;
    parity[t] = static_cast<char>(p);
    open.push_back(t);
  };
  for (std::uint32_t seed = 0; seed < net.triangles.size(); ++seed) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (net.neighbor[seed][k] == kNone) reach(seed, net.is_edge[seed][k] ? 1 : 0);
    }
    while (!open.empty()) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (std::size_t k = 0; k < 3; ++k) {
        if (net.neighbor[t][k] != kNone)
          reach(net.neighbor[t][k], parity[t] ^ (net.is_edge[t][k] ? 1 : 0));
      }
    }
  }
  const bool same = (space.normal(facet.plane)[space.main_axis(facet.plane)] > 0) == facet.along;
  for (std::size_t t = 0; t < net.triangles.size(); ++t) {
    if (parity[t] != 1) continue;
    auto c = net.triangles[t];
    if (!same) std::swap(c[1], c[2]);
    out.push_back(c);
  }
}

void check_closed(const Mesh& mesh) {
  std::unordered_map<std::uint64_t, int> balance;
  for (const Facet& f : mesh.facets) {
    for (const Edge& e : f.edges) balance[key(e.a, e.b)] += e.a < e.b ? 1 : -1;
  }
  for (const auto& [edge, sum] : balance) {
    if (sum != 0) throw GeometryError("a Boolean whose result is not closed");
  }
}

}  // namespace

void straighten(Space& space, Mesh& mesh) {
  check_closed(mesh);
  name_lines(space, mesh);
  std::unordered_map<Id, Passage> at;
  for (const Facet& f : mesh.facets) {
    for (const Edge& e : f.edges) {
      at[e.a].add(e.line, e.b);
      at[e.b].add(e.line, e.a);
    }
  }
  // Twice through one point in one facet: an edge and its way back.
  for (const Facet& f : mesh.facets) {
    std::unordered_map<Id, int> leaving;
    for (const Edge& e : f.edges) {
      if (++leaving[e.a] > 1) at[e.a].straight = false;
    }
  }
  for (Facet& f : mesh.facets) leave_out_passages(f, at);
}

Solid solid_of(Space& space, const Mesh& mesh) {
  Solid out;
  const auto less = [](const Vec3& a, const Vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  std::map<Vec3, std::uint32_t, decltype(less)> numbers(less);
  const auto number = [&](Id p) {
    const Vec3 at = space.at(p) + Vec3(0.0);  // no negative zeros
    const auto [found, fresh] =
        numbers.try_emplace(at, static_cast<std::uint32_t>(out.positions.size()));
    if (fresh) out.positions.push_back(at);
    return found->second;
  };
  std::vector<std::array<Id, 3>> triangles;
  for (const Facet& f : mesh.facets) {
    triangles.clear();
    fill(space, f, triangles);
    for (const auto& t : triangles) {
      const std::array<std::uint32_t, 3> c{number(t[0]), number(t[1]), number(t[2])};
      if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      out.triangles.push_back(c);
      out.surface.push_back(f.surface);
    }
  }
  return out;
}

}  // namespace burin::csg
