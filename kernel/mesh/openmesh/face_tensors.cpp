#include "face_tensors.h"

#include <burin/base/parallel.h>

#include "../build_steps.h"

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

/// The half-edges of a triangle, from corner 0 on.
using Around = std::array<RingHandle, 3>;

Around around(const RingMesh& rings, OpenMesh::FaceHandle face) {
  const RingHandle first = rings.halfedge_handle(face);
  return {first, rings.next_halfedge_handle(first), rings.prev_halfedge_handle(first)};
}

FaceFrame face_frame(const RingMesh& rings, const Around& h, const Vec3& fallback) {
  std::array<Vec3, 3> e;
  for (std::size_t k = 0; k < 3; ++k) e[k] = rings.to(h[k]) - rings.from(h[k]);
  FaceFrame result;
  const Vec3 twice_area = glm::cross(e[0], e[1]);
  result.area = 0.5 * glm::length(twice_area);
  result.frame.n = normalize_or(twice_area, fallback);
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

/// For each half-edge inside the tensor of its triangle at its origin.
std::unique_ptr<CornerTensor[]> corner_tensors(const RingMesh& rings, const ProxyMesh& proxy,
                                               const RunContext& context) {
  auto result = std::make_unique_for_overwrite<CornerTensor[]>(rings.n_halfedges());
  parallel_for(
      rings.n_faces(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          const Around h = around(rings, OpenMesh::FaceHandle(static_cast<int>(f)));
          std::array<Vec3, 3> normals;
          for (std::size_t k = 0; k < 3; ++k) {
            normals[k] = proxy.wedge_normal[wedge_of(proxy, rings.corner(h[k]))];
          }
          const FaceFrame face = face_frame(rings, h, normals[0]);
          const auto at = [&](std::size_t k) -> CornerTensor& {
            return result[static_cast<std::size_t>(h[k].idx())];
          };
          if (!(face.area > 0)) {
            for (std::size_t k = 0; k < 3; ++k) at(k) = {0, 0, 0, 0};
            continue;
          }
          const Tensor tensor = fit_tensor(face, normals);
          const std::array<double, 3> area = corner_areas(face);
          for (std::size_t k = 0; k < 3; ++k) {
            const Tensor t = area[k] * carried(tensor, face.frame, tangent_frame(normals[k]));
            at(k) = {t.mean, t.dx, t.dy, area[k]};
          }
        }
      },
      &context);
  return result;
}

}  // namespace

std::vector<Tensor> wedge_tensors(const RingMesh& rings, const Groups<RingHandle>& of_wedge,
                                  const ProxyMesh& proxy, const RunContext& context) {
  const auto at_corner = corner_tensors(rings, proxy, context);
  std::vector<Tensor> result(of_wedge.size());
  parallel_for(
      result.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) {
          double weight = 0;
          for (const RingHandle h : of_wedge[w]) {
            const CornerTensor& c = at_corner[static_cast<std::size_t>(h.idx())];
            result[w] += Tensor{c.mean, c.dx, c.dy};
            weight += c.area;
          }
          if (weight > 0) result[w] = (1 / weight) * result[w];
        }
      },
      &context);
  return result;
}

}  // namespace burin
