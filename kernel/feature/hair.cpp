#include "hair.h"

#include "paper_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace burin {

namespace {

std::uint32_t other_face(const ProxyMesh& proxy, HalfEdge h) {
  return face_of(proxy.topology.opposite[static_cast<std::size_t>(h)]);
}

double bend(const ProxyMesh& proxy, HalfEdge h) {
  const Vec3 a = proxy.mesh.normal(face_of(h)), b = proxy.mesh.normal(other_face(proxy, h));
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Whether the smooth region around `face` has no more than kIslandFaces triangles and kIslandArea.
bool island(const Facing& facing, std::uint32_t face) {
  const ProxyMesh& proxy = facing.proxy();
  std::vector<std::uint32_t> faces{face};
  double area = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces.size() > kIslandFaces) return false;
    const double scale =
        facing.camera().scale_at(proxy.mesh.positions[proxy.mesh.triangles[faces[i]][0]]);
    area += proxy.mesh.area(faces[i]) * scale * scale;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t h = 3 * std::size_t{faces[i]} + k;
      if (proxy.edge_kind[h] != EdgeKind::Smooth) continue;
      const std::uint32_t next = face_of(proxy.topology.opposite[h]);
      if (std::ranges::find(faces, next) == faces.end()) faces.push_back(next);
    }
  }
  return area < kIslandArea;
}

}  // namespace

bool is_hair(const Facing& facing, const EdgeChain& chain) {
  if (chain.kind == EdgeKind::Boundary) return false;
  const ProxyMesh& proxy = facing.proxy();
  double weighted = 0, sharpest = 0;
  for (const HalfEdge h : chain.edges) {
    const Vec3& a = proxy.mesh.positions[origin(proxy.mesh, h)];
    const Vec3& b = proxy.mesh.positions[origin(proxy.mesh, next_in_face(h))];
    const double angle = bend(proxy, h);
    weighted += glm::length(b - a) * facing.camera().scale_at(a) * angle / (std::numbers::pi / 2);
    sharpest = std::max(sharpest, angle);
    if (weighted >= kHairLength) return false;
  }
  const std::uint32_t left = face_of(chain.edges.front());
  const std::uint32_t right = other_face(proxy, chain.edges.front());
  if (proxy.face_region[left] == proxy.face_region[right]) return true;
  return sharpest < kIslandBend && (island(facing, left) || island(facing, right));
}

}  // namespace burin
