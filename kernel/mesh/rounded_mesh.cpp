#include <burin/mesh/rounded_mesh.h>

#include <algorithm>

namespace burin {

namespace {

// An edge whose normals ask for a bulge of more than about this share of its length is no sample of
// a smooth surface.
constexpr double kMostLift = 0.27;

}  // namespace

RoundedMesh::RoundedMesh(const ProxyMesh& proxy)
    : proxy_(&proxy), sharp_(proxy.mesh.positions.size(), 0) {
  for (std::size_t h = 0; h < proxy.edge_kind.size(); ++h) {
    if (proxy.edge_kind[h] == EdgeKind::Smooth) continue;
    sharp_[origin(proxy.mesh, static_cast<HalfEdge>(h))] = 1;
    sharp_[origin(proxy.mesh, next_in_face(static_cast<HalfEdge>(h)))] = 1;
  }
}

// What the control point of the edge's cubic beside wedge a is off the straight edge, times three:
// the edge projected onto the plane of a's normal.
Vec3 RoundedMesh::control_lift(std::uint32_t a, std::uint32_t b) const {
  if (sharp_[proxy_->wedge_vertex[a]] || sharp_[proxy_->wedge_vertex[b]]) return Vec3(0);
  const Vec3 chord = proxy_->wedge_position(b) - proxy_->wedge_position(a);
  const Vec3& n = proxy_->wedge_normal[a];
  const Vec3 lift = -glm::dot(chord, n) * n;
  const double most = 3 * kMostLift * glm::length(chord), high = glm::length(lift);
  return high > most ? most / high * lift : lift;
}

Vec3 RoundedMesh::on_edge(std::uint32_t a, std::uint32_t b, double t) const {
  const Vec3 &p = proxy_->wedge_position(a), &q = proxy_->wedge_position(b);
  return p + t * (q - p) + t * (1 - t) * ((1 - t) * control_lift(a, b) + t * control_lift(b, a));
}

Vec3 RoundedMesh::on_face(std::uint32_t face, Vec3 bary) const {
  const Triangle& w = proxy_->wedges[face];
  Vec3 off(0), middle(0);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vec3 ab = control_lift(w[static_cast<std::size_t>(i)], w[static_cast<std::size_t>(j)]);
    const Vec3 ba = control_lift(w[static_cast<std::size_t>(j)], w[static_cast<std::size_t>(i)]);
    off += bary[i] * bary[j] * (bary[i] * ab + bary[j] * ba);
    middle += ab + ba;
  }
  // The inner control point lies half as far again off the triangle as the mean of the six on the
  // edges: each of those is a third of its lift off.
  const Vec3 inner = 1.5 * middle / 18.0;
  return proxy_->position(face, bary) + off + 6 * bary.x * bary.y * bary.z * inner;
}

}  // namespace burin
