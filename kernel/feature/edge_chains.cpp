#include "edge_chains.h"

#include <burin/base/parallel.h>

#include <algorithm>
#include <array>

namespace burin {

namespace {

constexpr std::size_t kEdgeGrain = 65536;

/// One half-edge for each crease or boundary edge, ascending.
std::vector<HalfEdge> feature_edges(const ProxyMesh& proxy, const RunContext& context) {
  const std::size_t n = proxy.edge_kind.size();
  std::vector<std::vector<HalfEdge>> found((n + kEdgeGrain - 1) / kEdgeGrain);
  parallel_for(
      n, kEdgeGrain,
      [&](std::size_t begin, std::size_t end) {
        std::vector<HalfEdge>& out = found[begin / kEdgeGrain];
        for (std::size_t h = begin; h < end; ++h) {
          if (proxy.edge_kind[h] == EdgeKind::Smooth) continue;
          const HalfEdge o = proxy.topology.opposite[h];
          if (o == kNoHalfEdge || static_cast<HalfEdge>(h) < o) {
            out.push_back(static_cast<HalfEdge>(h));
          }
        }
      },
      &context);
  std::vector<HalfEdge> all;
  for (const auto& part : found) all.insert(all.end(), part.begin(), part.end());
  return all;
}

class Chainer {
 public:
  Chainer(const ProxyMesh& proxy, const std::vector<HalfEdge>& edges)
      : proxy_(proxy),
        degree_(proxy.mesh.positions.size(), 0),
        incident_(proxy.mesh.positions.size()),
        used_(proxy.edge_kind.size(), 0) {
    for (const HalfEdge h : edges) {
      add(origin(proxy_.mesh, h), h);
      add(target(h), h);
    }
  }

  bool used(HalfEdge h) const { return used_[static_cast<std::size_t>(h)] != 0; }

  EdgeChain chain_from(HalfEdge start) {
    EdgeChain chain;
    chain.kind = kind(start);
    chain.edges = run(start, chain.closed);
    const HalfEdge back = reversed(start);
    if (chain.closed) return chain;
    // A boundary has no half-edge that runs backwards: its predecessors are found edge by edge.
    std::vector<HalfEdge> before = back == kNoHalfEdge ? run_back(start) : run(back, chain.closed);
    if (back != kNoHalfEdge) {
      before.erase(before.begin());
      for (HalfEdge& h : before) h = reversed(h);
    }
    std::reverse(before.begin(), before.end());
    chain.edges.insert(chain.edges.begin(), before.begin(), before.end());
    return chain;
  }

 private:
  EdgeKind kind(HalfEdge h) const { return proxy_.edge_kind[static_cast<std::size_t>(h)]; }
  HalfEdge reversed(HalfEdge h) const {
    return proxy_.topology.opposite[static_cast<std::size_t>(h)];
  }
  std::uint32_t target(HalfEdge h) const { return origin(proxy_.mesh, next_in_face(h)); }

  void add(std::uint32_t vertex, HalfEdge h) {
    std::uint8_t& d = degree_[vertex];
    if (d < 2) incident_[vertex][d] = h;
    if (d < 3) ++d;
  }

  void mark(HalfEdge h) {
    used_[static_cast<std::size_t>(h)] = 1;
    if (reversed(h) != kNoHalfEdge) used_[static_cast<std::size_t>(reversed(h))] = 1;
  }

  /// The edge that goes on over `vertex` from the edge of `h`, as stored; kNoHalfEdge at an end.
  HalfEdge other(std::uint32_t vertex, HalfEdge h) const {
    if (degree_[vertex] != 2) return kNoHalfEdge;
    const auto& [a, b] = incident_[vertex];
    const HalfEdge next = a == h || a == reversed(h) ? b : a;
    return kind(next) == kind(h) ? next : kNoHalfEdge;
  }

  std::vector<HalfEdge> run(HalfEdge start, bool& closed) {
    std::vector<HalfEdge> edges{start};
    mark(start);
    for (HalfEdge h = start;;) {
      const std::uint32_t v = target(h);
      HalfEdge next = other(v, h);
      if (next != kNoHalfEdge && origin(proxy_.mesh, next) != v) next = reversed(next);
      closed = next == start;
      if (next == kNoHalfEdge || used(next)) return edges;
      mark(next);
      edges.push_back(next);
      h = next;
    }
  }

  std::vector<HalfEdge> run_back(HalfEdge start) {
    std::vector<HalfEdge> edges;
    for (HalfEdge h = start;;) {
      const HalfEdge previous = other(origin(proxy_.mesh, h), h);
      if (previous == kNoHalfEdge || used(previous) || target(previous) != origin(proxy_.mesh, h)) {
        return edges;
      }
      mark(previous);
      edges.push_back(previous);
      h = previous;
    }
  }

  const ProxyMesh& proxy_;
  /// Creases and boundaries at each vertex (3 = three or more), and the first two of them.
  std::vector<std::uint8_t> degree_;
  std::vector<std::array<HalfEdge, 2>> incident_;
  std::vector<std::uint8_t> used_;
};

}  // namespace

std::vector<EdgeChain> chain_edges(const ProxyMesh& proxy, const RunContext& context) {
  const std::vector<HalfEdge> edges = feature_edges(proxy, context);
  std::vector<EdgeChain> chains;
  if (edges.empty()) return chains;
  Chainer chainer(proxy, edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i % 4096 == 0) context.check();
    if (!chainer.used(edges[i])) chains.push_back(chainer.chain_from(edges[i]));
  }
  return chains;
}

}  // namespace burin
