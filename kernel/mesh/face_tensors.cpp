#include "face_tensors.h"

#include <burin/base/parallel.h>

#include "build_steps.h"

#include <algorithm>
#include <array>
#include <memory>

namespace burin {

namespace {

/// The tensor of a triangle in the frame of the wedge at one corner, times the share of the
/// triangle's area that belongs to the corner. Without initialisers, so that a hundred megabytes of
/// them are not written twice.
struct CornerTensor {
  double mean, dx, dy, area;
};

struct FaceFrame {
  TangentFrame frame;
  std::array<Vec2, 3> edge;  // edge k runs from corner k to corner k + 1
  double area = 0;
};

FaceFrame face_frame(const ProxyMesh& proxy, std::size_t f) {
  const Triangle& t = proxy.mesh.triangles[f];
  std::array<Vec3, 3> e;
  for (std::size_t k = 0; k < 3; ++k) {
    e[k] = proxy.mesh.positions[t[(k + 1) % 3]] - proxy.mesh.positions[t[k]];
  }
  FaceFrame result;
  const Vec3 twice_area = glm::cross(e[0], e[1]);
  result.area = 0.5 * glm::length(twice_area);
  result.frame.n = normalize_or(twice_area, proxy.wedge_normal[proxy.wedges[f][0]]);
  result.frame.u = normalize_or(e[0], any_orthogonal(result.frame.n));
  result.frame.v = glm::cross(result.frame.n, result.frame.u);
  for (std::size_t k = 0; k < 3; ++k) {
    result.edge[k] = {glm::dot(e[k], result.frame.u), glm::dot(e[k], result.frame.v)};
  }
  return result;
}

/// The symmetric tensor that maps the three edges to the changes of the normals along them, by
/// least squares.
Tensor fit_tensor(const FaceFrame& face, const std::array<Vec3, 3>& normals) {
  double xx = 0, xy = 0, yy = 0, r0 = 0, r1 = 0, r2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 e = face.edge[k];
    const Vec3 change = normals[(k + 1) % 3] - normals[k];
    const Vec2 dn(glm::dot(change, face.frame.u), glm::dot(change, face.frame.v));
    xx += e.x * e.x;
    xy += e.x * e.y;
    yy += e.y * e.y;
    r0 += e.x * dn.x;
    r1 += e.x * dn.y + e.y * dn.x;
    r2 += e.y * dn.y;
  }
  // [xx xy 0; xy xx+yy xy; 0 xy yy] (a b c) = r, in closed form; its determinant is trace * (xx yy
  // - xy^2).
  const double minor = xx * yy - xy * xy, trace = xx + yy;
  if (!(minor > 1e-18 * trace * trace)) return {};  // a needle of aspect 1e-9 has no tensor
  const double b = (r1 * xx * yy - xy * (r0 * yy + r2 * xx)) / (trace * minor);
  const double a = (r0 - xy * b) / xx, c = (r2 - xy * b) / yy;
  return {0.5 * (a + c), 0.5 * (a - c), b};
}

/// Voronoi areas of the corners; an obtuse triangle gives half of itself to the obtuse corner.
/// @cite Meyer2003
std::array<double, 3> corner_areas(const FaceFrame& face) {
  std::array<double, 3> length2, cotangent, result;
  for (std::size_t k = 0; k < 3; ++k) {
    length2[k] = glm::dot(face.edge[k], face.edge[k]);
    cotangent[k] = -glm::dot(face.edge[k], face.edge[(k + 2) % 3]);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (cotangent[k] > 0) continue;
    result.fill(0.25 * face.area);
    result[k] = 0.5 * face.area;
    return result;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, before = (k + 2) % 3;
    result[k] =
        (length2[k] * cotangent[before] + length2[before] * cotangent[next]) / (16 * face.area);
  }
  return result;
}

std::unique_ptr<CornerTensor[]> corner_tensors(const ProxyMesh& proxy, const RunContext& context) {
  const std::size_t faces = proxy.mesh.triangles.size();
  auto result = std::make_unique_for_overwrite<CornerTensor[]>(3 * faces);
  parallel_for(
      faces, kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          const FaceFrame face = face_frame(proxy, f);
          if (!(face.area > 0)) {
            std::fill_n(&result[3 * f], 3, CornerTensor{0, 0, 0, 0});
            continue;
          }
          const Triangle& w = proxy.wedges[f];
          const std::array<Vec3, 3> normals = {proxy.wedge_normal[w[0]], proxy.wedge_normal[w[1]],
                                               proxy.wedge_normal[w[2]]};
          const Tensor tensor = fit_tensor(face, normals);
          const std::array<double, 3> area = corner_areas(face);
          for (std::size_t k = 0; k < 3; ++k) {
            const Tensor t = area[k] * carried(tensor, face.frame, tangent_frame(normals[k]));
            result[3 * f + k] = {t.mean, t.dx, t.dy, area[k]};
          }
        }
      },
      &context);
  return result;
}

}  // namespace

std::vector<Tensor> wedge_tensors(const ProxyMesh& proxy, const Corners& corners,
                                  const RunContext& context) {
  const auto at_corner = corner_tensors(proxy, context);
  std::vector<Tensor> result(proxy.wedge_vertex.size());
  std::vector<double> weight(result.size(), 0);
  parallel_for(
      proxy.mesh.positions.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
          for (const HalfEdge h : corners[v]) {
            const std::uint32_t w = wedge_of(proxy, h);
            const CornerTensor& c = at_corner[static_cast<std::size_t>(h)];
            result[w] += Tensor{c.mean, c.dx, c.dy};
            weight[w] += c.area;
          }
          for (const HalfEdge h : corners[v]) {
            const std::uint32_t w = wedge_of(proxy, h);
            if (weight[w] > 0) result[w] = (1 / weight[w]) * result[w];
            weight[w] = 0;
          }
        }
      },
      &context);
  return result;
}

}  // namespace burin
