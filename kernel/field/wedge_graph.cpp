#include "wedge_graph.h"

#include <burin/base/parallel.h>
#include <burin/mesh/corners.h>

#include "links.h"

#include <span>

namespace burin::field {
namespace {

std::uint32_t wedge_at(const ProxyMesh& proxy, HalfEdge h) {
  return proxy.wedges[face_of(h)][static_cast<std::size_t>(h % 3)];
}

// What each triangle adds to the links along its edges.
std::vector<double> edge_shares(const ProxyMesh& proxy, const std::vector<std::uint8_t>& skipped,
                                const RunContext& context) {
  std::vector<double> share(3 * proxy.wedges.size(), 0);
  parallel_for(
      proxy.wedges.size(), kGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          if (skipped[f]) continue;
          const double area = proxy.mesh.area(static_cast<std::uint32_t>(f));
          for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& t = proxy.mesh.triangles[f];
            const Vec3 e = proxy.mesh.positions[t[(k + 1) % 3]] - proxy.mesh.positions[t[k]];
            const double length2 = glm::dot(e, e);
            if (length2 > 0) share[3 * f + k] = 2 * area / (3 * length2);
          }
        }
      },
      &context);
  return share;
}

// Calls `link(neighbour, weight)` for the links of the wedge with the given corners.
template <class Link>
void for_links(const ProxyMesh& proxy, const std::vector<double>& share,
               const std::vector<std::uint8_t>& skipped, std::span<const HalfEdge> corners,
               const Link& link) {
  const auto partner = [&](HalfEdge h) {
    const auto i = static_cast<std::size_t>(h);
    if (proxy.edge_kind[i] != EdgeKind::Smooth) return kNoHalfEdge;
    const HalfEdge o = proxy.topology.opposite[i];
    return skipped[face_of(o)] ? kNoHalfEdge : o;
  };
  for (const HalfEdge out : corners) {
    if (skipped[face_of(out)]) continue;
    const HalfEdge in = prev_in_face(out), beside = partner(out);
    const double beyond = beside == kNoHalfEdge ? 0 : share[static_cast<std::size_t>(beside)];
    link(wedge_at(proxy, next_in_face(out)), share[static_cast<std::size_t>(out)] + beyond);
    // The edge that comes in goes out of a neighbouring corner, unless it is the last one of a fan.
    if (partner(in) == kNoHalfEdge) link(wedge_at(proxy, in), share[static_cast<std::size_t>(in)]);
  }
}

}  // namespace

Vec2 wedge_turn(const ProxyMesh& proxy, const WedgeGraph& graph, std::uint32_t from,
                std::uint32_t to) {
  return turn(TangentBasis(proxy.wedge_normal[from], graph.axis[from]),
              TangentBasis(proxy.wedge_normal[to], graph.axis[to]));
}

WedgeGraph build_wedge_graph(const ProxyMesh& proxy, const std::vector<std::uint8_t>& skipped,
                             const RunContext& context) {
  const std::size_t n = proxy.wedge_vertex.size();
  WedgeGraph g;
  Corners corners;
  std::vector<double> share;
  parallel_invoke([&] { corners = corners_at(proxy.wedges, n); },
                  [&] { share = edge_shares(proxy, skipped, context); });
  g.axis.resize(n);
  g.area.assign(n, 0);
  g.region.assign(n, 0);
  Links<Vec2>& s = g.crosses;
  s.first.assign(n + 1, 0);
  s.stiffness.assign(n, 0);
  const auto links = [&](std::size_t w, const auto& link) {
    for_links(proxy, share, skipped, corners[w], link);
  };
  const auto prepare = [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w) {
      g.axis[w] = any_orthogonal(proxy.wedge_normal[w]);
      links(w, [&](std::uint32_t, double) { ++s.first[w + 1]; });
      for (const HalfEdge corner : corners[w]) {
        const std::uint32_t f = face_of(corner);
        g.region[w] = proxy.face_region[f];
        if (!skipped[f]) g.area[w] += proxy.mesh.area(f) / 3;
      }
    }
  };
  parallel_for(n, kGrain, prepare, &context);
  for (std::size_t w = 0; w < n; ++w) s.first[w + 1] += s.first[w];
  s.neighbour.resize(s.first[n]);
  s.coupling.resize(s.first[n]);
  const auto fill = [&](std::size_t begin, std::size_t end) {
    for (std::size_t w = begin; w < end; ++w) {
      std::uint32_t k = s.first[w];
      links(w, [&](std::uint32_t j, double weight) {
        const Vec2 r = wedge_turn(proxy, g, j, static_cast<std::uint32_t>(w));
        s.neighbour[k] = j;
        s.coupling[k++] = weight * complex_square(complex_square(r));
        s.stiffness[w] += weight;
      });
    }
  };
  parallel_for(n, kGrain, fill, &context);
  return g;
}

}  // namespace burin::field
