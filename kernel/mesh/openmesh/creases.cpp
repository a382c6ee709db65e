#include <burin/base/parallel.h>

#include "../build_steps.h"
#include "ring_steps.h"

#include <cmath>
#include <numbers>

namespace burin {

namespace {

/// Degrees over the crease angle that are still smooth: a circle of twelve facets bends by 30.00
/// degrees, which single precision files round to either side.
constexpr double kSlack = 0.006;

}  // namespace

EdgeKind crease_kind(const ProxyMesh& proxy, const std::vector<Vec3>& normals, HalfEdge h) {
  const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(h)];
  const Vec3 along =
      proxy.mesh.positions[origin(proxy.mesh, o)] - proxy.mesh.positions[origin(proxy.mesh, h)];
  const Vec3 turn = glm::cross(normals[face_of(h)], normals[face_of(o)]);
  return glm::dot(turn, along) >= 0 ? EdgeKind::ConvexCrease : EdgeKind::ConcaveCrease;
}

void classify_edges(const RingMesh& rings, ProxyMesh& proxy, const std::vector<Vec3>& normals,
                    double crease_angle, const RunContext& context) {
  const double limit = std::cos((crease_angle + kSlack) * std::numbers::pi / 180);
  proxy.edge_kind.resize(3 * rings.n_faces());
  const auto kind = [&](RingHandle inside, RingHandle opposite) {
    if (rings.is_boundary(opposite)) return EdgeKind::Boundary;
    const Vec3& a = normals[rings.triangle(inside)];
    const Vec3& b = normals[rings.triangle(opposite)];
    if (glm::dot(a, b) >= limit) return EdgeKind::Smooth;
    return crease_kind(proxy, normals, rings.corner(inside));
  };
  const auto set = [&](RingHandle h, EdgeKind k) {
    proxy.edge_kind[static_cast<std::size_t>(rings.corner(h))] = k;
  };
  parallel_for(
      rings.n_edges(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e) {
          const OpenMesh::EdgeHandle edge(static_cast<int>(e));
          const RingHandle h = rings.halfedge_handle(edge, 0), o = rings.halfedge_handle(edge, 1);
          const EdgeKind found = kind(h, o);
          set(h, found);
          if (!rings.is_boundary(o)) set(o, found);
        }
      },
      &context);
}

}  // namespace burin
