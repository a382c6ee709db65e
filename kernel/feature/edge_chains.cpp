#include "edge_chains.h"

#include <burin/base/parallel_filter.h>

#include <algorithm>
#include <array>
#include <span>

namespace burin {

namespace {

constexpr std::size_t kEdgeGrain = 65536;

/// One half-edge for each edge that is wanted, ascending.
std::vector<HalfEdge> feature_edges(const ProxyMesh& proxy, const FeatureOptions& options,
                                    const RunContext& context) {
  const auto wanted = [&](HalfEdge h) {
    const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(h)];
    return (o == kNoHalfEdge || h <= o) && is_chained(proxy, h, options);
  };
  return parallel_filter<HalfEdge>(proxy.edge_kind.size(), kEdgeGrain, wanted, context);
}

class Chainer {
 public:
  explicit Chainer(const ProxyMesh& proxy)
      : proxy_(proxy),
        degree_(proxy.mesh.positions.size(), 0),
        incident_(proxy.mesh.positions.size()),
        used_(proxy.edge_kind.size(), 0) {}

  /// Chains of these edges, as if there were no others.
  void chain(std::span<const HalfEdge> edges, std::vector<EdgeChain>& out) {
    for (const HalfEdge h : edges) {
      add(origin(proxy_.mesh, h), h);
      add(target(h), h);
    }
    for (const HalfEdge h : edges) {
      if (!used(h)) out.push_back(chain_from(h));
    }
    for (const HalfEdge h : edges) degree_[origin(proxy_.mesh, h)] = degree_[target(h)] = 0;
  }

 private:
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

bool is_chained(const ProxyMesh& proxy, HalfEdge half_edge, const FeatureOptions& options) {
  const auto h = static_cast<std::size_t>(half_edge);
  if (proxy.edge_kind[h] != EdgeKind::Smooth) return true;
  if (proxy.source_edge.empty() || proxy.source_edge[h] < 0) return false;
  const bool seam = !proxy.seam.empty() && proxy.seam[h] != 0;
  return seam ? options.seams : options.smooth;
}

std::vector<EdgeChain> chain_edges(const ProxyMesh& proxy, const FeatureOptions& options,
                                   const RunContext& context) {
  std::vector<HalfEdge> edges = feature_edges(proxy, options, context);
  std::vector<EdgeChain> chains;
  if (edges.empty()) return chains;
  Chainer chainer(proxy);
  if (proxy.source_edge.empty()) {
    chainer.chain(edges, chains);
    for (std::size_t i = 0; i < chains.size(); ++i) {
      chains[i].source = static_cast<std::int32_t>(i);
    }
    return chains;
  }
  const auto source = [&](HalfEdge h) { return proxy.source_edge[static_cast<std::size_t>(h)]; };
  std::ranges::stable_sort(edges, {}, source);
  for (auto first = edges.begin(); first != edges.end();) {
    context.check();
    const auto last =
        std::find_if(first, edges.end(), [&](HalfEdge h) { return source(h) != source(*first); });
    const std::size_t before = chains.size();
    chainer.chain({first, last}, chains);
    for (std::size_t i = before; i < chains.size(); ++i) {
      const auto h = static_cast<std::size_t>(chains[i].edges.front());
      chains[i].source = proxy.source_edge[h];
      chains[i].seam = !proxy.seam.empty() && proxy.seam[h] != 0;
    }
    first = last;
  }
  return chains;
}

std::vector<EdgeChain> chain_folds(const ProxyMesh& proxy, std::span<const HalfEdge> folds) {
  std::vector<EdgeChain> chains;
  if (folds.empty()) return chains;
  Chainer(proxy).chain(folds, chains);
  for (EdgeChain& chain : chains) chain.fold = true;
  return chains;
}

}  // namespace burin
