#include <burin/base/parallel.h>

#include "build_steps.h"

#include <algorithm>
#include <cmath>

namespace burin {

namespace {

/// The angle of a triangle at corner `h`.
double corner_angle(const TriMesh& mesh, HalfEdge h) {
  const Vec3& p = mesh.positions[origin(mesh, h)];
  const Vec3 a = mesh.positions[origin(mesh, next_in_face(h))] - p;
  const Vec3 b = mesh.positions[origin(mesh, prev_in_face(h))] - p;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::uint32_t wedge_of(const ProxyMesh& proxy, HalfEdge h) {
  return proxy.wedges[face_of(h)][static_cast<std::size_t>(h % 3)];
}

}  // namespace

void find_wedge_normals(ProxyMesh& proxy, const VertexCorners& corners,
                        const std::vector<Vec3>& face_normals, const RunContext& context) {
  proxy.wedge_normal.assign(proxy.wedge_vertex.size(), Vec3(0));
  parallel_for(
      proxy.mesh.positions.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          for (const HalfEdge h : corners.of(v)) {
            proxy.wedge_normal[wedge_of(proxy, h)] +=
                face_normals[face_of(h)] * corner_angle(proxy.mesh, h);
          }
          for (const HalfEdge h : corners.of(v)) {
            Vec3& n = proxy.wedge_normal[wedge_of(proxy, h)];
            n = normalize_or(n, Vec3(0, 0, 1));
          }
        }
      },
      &context);
}

void find_sagitta(ProxyMesh& proxy, const VertexCorners& corners, const RunContext& context) {
  std::vector<float> of_face(proxy.mesh.triangles.size());
  parallel_for(
      of_face.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          double largest = 0;
          for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = proxy.wedges[f][k], b = proxy.wedges[f][(k + 1) % 3];
            largest =
                std::max(largest, glm::length(proxy.wedge_position(a) - proxy.wedge_position(b)) *
                                      glm::length(proxy.wedge_normal[a] - proxy.wedge_normal[b]));
          }
          of_face[f] =
              static_cast<float>(largest / 8);  // h^2 k / 8 with k = |change of normal| / h
        }
      },
      &context);
  proxy.wedge_sagitta.assign(proxy.wedge_vertex.size(), 0);
  parallel_for(
      proxy.mesh.positions.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          for (const HalfEdge h : corners.of(v)) {
            float& sagitta = proxy.wedge_sagitta[wedge_of(proxy, h)];
            sagitta = std::max(sagitta, of_face[face_of(h)]);
          }
        }
      },
      &context);
}

}  // namespace burin
