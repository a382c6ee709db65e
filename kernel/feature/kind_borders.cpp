#include <burin/feature/kind_borders.h>

#include "edge_chains.h"

#include <unordered_map>
#include <utility>

namespace burin {
namespace {

/// Edges as ways from vertex to vertex, each to be gone once.
class Ways {
 public:
  explicit Ways(const ProxyMesh& proxy) : proxy_(proxy) {}

  void add(HalfEdge h) {
    const auto number = static_cast<std::uint32_t>(edges_.size());
    const std::uint32_t a = origin(proxy_.mesh, h), b = origin(proxy_.mesh, next_in_face(h));
    edges_.push_back({h, a, b});
    at_[a].push_back(number);
    at_[b].push_back(number);
  }

  std::vector<Curve3> chains(std::int32_t part) {
    std::vector<Curve3> out;
    gone_.assign(edges_.size(), false);
    // Chains end where more or fewer than two edges meet; what is left then are loops.
    for (const bool loops : {false, true}) {
      for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        for (const std::uint32_t from : {edges_[e].a, edges_[e].b}) {
          if (!gone_[e] && (loops || at_.at(from).size() != 2)) out.push_back(chain(e, from, part));
        }
      }
    }
    return out;
  }

 private:
  struct Edge {
    HalfEdge half_edge;
    std::uint32_t a, b;
  };

  Curve3 chain(std::uint32_t edge, std::uint32_t from, std::int32_t part) {
    const std::uint32_t start = from;
    Curve3 curve;
    curve.kind = LineClass::Smooth;
    curve.source = {part, proxy_.face_source(face_of(edges_[edge].half_edge)), -1};
    curve.points.push_back(proxy_.mesh.positions[from]);
    for (;;) {
      gone_[edge] = true;
      curve.faces.push_back(static_cast<std::int32_t>(face_of(edges_[edge].half_edge)));
      from = edges_[edge].a == from ? edges_[edge].b : edges_[edge].a;
      if (from == start) break;
      curve.points.push_back(proxy_.mesh.positions[from]);
      const std::vector<std::uint32_t>& here = at_.at(from);
      if (here.size() != 2) break;
      edge = here[0] == edge ? here[1] : here[0];
      if (gone_[edge]) break;
    }
    curve.closed = from == start;
    return curve;
  }

  const ProxyMesh& proxy_;
  std::vector<Edge> edges_;
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> at_;
  std::vector<bool> gone_;
};

}  // namespace

std::vector<Curve3> kind_borders(const ProxyMesh& proxy, std::int32_t part,
                                 const std::function<std::int32_t(std::int32_t face)>& kind,
                                 const FeatureOptions& lines) {
  Ways ways(proxy);
  for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    const HalfEdge o = proxy.topology.opposite[i];
    if (o <= h || proxy.edge_kind[i] != EdgeKind::Smooth) continue;
    if (is_chained(proxy, h, lines)) continue;
    const std::int32_t f = proxy.face_source(face_of(h)), g = proxy.face_source(face_of(o));
    if (f != g && kind(f) != kind(g)) ways.add(h);
  }
  return ways.chains(part);
}

}  // namespace burin
