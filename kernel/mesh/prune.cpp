#include <burin/base/parallel.h>

#include "build_steps.h"

#include <numeric>

namespace burin {

namespace {

/// Longest chain, in edges, that counts as a hair.
constexpr std::uint32_t kHair = 6;

/// Sets of vertices joined by creases.
class Chains {
 public:
  explicit Chains(std::size_t vertices)
      : parent_(vertices), edges_(vertices, 0), keep_(vertices, 0) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    if (a == b) {
      keep_[a] = 1;  // a closed loop
      ++edges_[a];
      return;
    }
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    edges_[a] += edges_[b] + 1;
    keep_[a] |= keep_[b];
  }

  void keep(std::uint32_t v) { keep_[root(v)] = 1; }

  bool is_hair(std::uint32_t v) {
    v = root(v);
    return keep_[v] == 0 && edges_[v] <= kHair;
  }

 private:
  std::uint32_t root(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> edges_;
  std::vector<std::uint8_t> keep_;
};

}  // namespace

void prune_hairs(ProxyMesh& proxy, const RunContext& context) {
  const std::size_t halfedges = proxy.edge_kind.size(), grain = 3 * kFaceGrain;
  std::vector<std::vector<HalfEdge>> found((halfedges + grain - 1) / grain);
  parallel_for(
      halfedges, grain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const auto h = static_cast<HalfEdge>(i);
          if (proxy.edge_kind[i] == EdgeKind::Boundary ||
              (proxy.is_crease(h) && h < proxy.topology.opposite[i])) {
            found[begin / grain].push_back(h);
          }
        }
      },
      &context);
  const auto each = [&](bool creases, const auto& visit) {
    for (const auto& part : found) {
      for (const HalfEdge h : part) {
        if (proxy.is_crease(h) == creases) {
          visit(h, origin(proxy.mesh, h), origin(proxy.mesh, next_in_face(h)));
        }
      }
    }
  };
  std::size_t creases = 0;
  each(true, [&](HalfEdge, std::uint32_t, std::uint32_t) { ++creases; });
  if (creases == 0) return;
  Chains chains(proxy.mesh.positions.size());
  each(true, [&](HalfEdge, std::uint32_t a, std::uint32_t b) { chains.join(a, b); });
  each(false, [&](HalfEdge, std::uint32_t a, std::uint32_t b) {
    chains.keep(a);
    chains.keep(b);
  });
  each(true, [&](HalfEdge h, std::uint32_t a, std::uint32_t) {
    if (!chains.is_hair(a)) return;
    const auto i = static_cast<std::size_t>(h);
    proxy.edge_kind[i] = EdgeKind::Smooth;
    proxy.edge_kind[static_cast<std::size_t>(proxy.topology.opposite[i])] = EdgeKind::Smooth;
  });
}

}  // namespace burin
