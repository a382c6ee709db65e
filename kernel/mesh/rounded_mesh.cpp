#include <burin/mesh/rounded_mesh.h>

#include <algorithm>
#include <limits>

namespace burin {

namespace {

// The bulge that an edge may have, as a share of the shortest edge at its ends, by three: a smooth
// surface sampled evenly turns by at most the crease angle over an edge, which is a bulge of about
// 0.07 edges. Where facets are long and thin (a cone as CAD programs export it) the normals at a
// faint kink would bend the long edges far outward: there the bulge is that of the fine direction.
constexpr double kMostLift = 3 * 0.15;

}  // namespace

RoundedMesh::RoundedMesh(const ProxyMesh& proxy)
    : proxy_(&proxy), finest_(proxy.mesh.positions.size(), std::numeric_limits<float>::max()) {
  const TriMesh& mesh = proxy.mesh;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[f][k], b = mesh.triangles[f][(k + 1) % 3];
      const bool smooth = proxy.edge_kind[3 * f + k] == EdgeKind::Smooth;
      const float length =
          smooth ? static_cast<float>(glm::distance(mesh.positions[a], mesh.positions[b])) : 0.0f;
      finest_[a] = std::min(finest_[a], length);
      finest_[b] = std::min(finest_[b], length);
    }
  }
}

// What the control point of the edge's cubic beside wedge a is off the straight edge, times three:
// the edge projected onto the plane of a's normal.
Vec3 RoundedMesh::control_lift(std::uint32_t a, std::uint32_t b) const {
  const double most =
      kMostLift * std::min(finest_[proxy_->wedge_vertex[a]], finest_[proxy_->wedge_vertex[b]]);
  if (most <= 0) return Vec3(0);
  const Vec3& n = proxy_->wedge_normal[a];
  const double lift = -glm::dot(proxy_->wedge_position(b) - proxy_->wedge_position(a), n);
  return std::clamp(lift, -most, most) * n;
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
