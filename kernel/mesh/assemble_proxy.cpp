#include <burin/base/parallel.h>
#include <burin/mesh/proxy_mesh.h>

#include "build_steps.h"

#include <cmath>
#include <utility>

namespace burin {

namespace {

/// Sine of the angle between the normals of both sides below which they do not tell to which side
/// an edge bends: rounding of exact normals is 1e-15, of traced edges 1e-8.
constexpr double kBend = 1e-6;

/// The normal along the edge of `h` on the side of its triangle.
Vec3 edge_normal(const TriMesh& mesh, const ProxyDraft& draft, HalfEdge h) {
  return normalize_or(draft.corner_normal[static_cast<std::size_t>(h)] +
                          draft.corner_normal[static_cast<std::size_t>(next_in_face(h))],
                      mesh.normal(face_of(h)));
}

/// Whether the surface bends away from the outside at the edge of `h`.
bool convex(const TriMesh& mesh, const ProxyDraft& draft, HalfEdge h, HalfEdge o) {
  const Vec3& a = mesh.positions[origin(mesh, h)];
  const Vec3 along = normalize_or(mesh.positions[origin(mesh, o)] - a, Vec3(0));
  const Vec3 left = edge_normal(mesh, draft, h), right = edge_normal(mesh, draft, o);
  const double bend = glm::dot(glm::cross(left, right), along);
  if (std::abs(bend) > kBend) return bend > 0;
  // A knife's edge or the slot between two walls that touch: the triangles themselves tell.
  const auto into = [&](HalfEdge e) {
    const Vec3& apex = mesh.positions[origin(mesh, prev_in_face(e))];
    return normalize_or(reject(apex - a, along), Vec3(0));
  };
  return glm::dot(left, into(o)) + glm::dot(right, into(h)) <= 0;
}

void find_edge_kinds(ProxyMesh& proxy, const ProxyDraft& draft, const RunContext& context) {
  const std::vector<HalfEdge>& opposite = proxy.topology.opposite;
  proxy.edge_kind.resize(opposite.size());
  const auto kind = [&](std::size_t h) {
    const HalfEdge o = opposite[h];
    if (o == kNoHalfEdge) return EdgeKind::Boundary;
    if (!draft.sharp[h] && !draft.sharp[static_cast<std::size_t>(o)]) return EdgeKind::Smooth;
    return convex(proxy.mesh, draft, static_cast<HalfEdge>(h), o) ? EdgeKind::ConvexCrease
                                                                  : EdgeKind::ConcaveCrease;
  };
  parallel_for(
      opposite.size(), 3 * kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t h = begin; h < end; ++h) proxy.edge_kind[h] = kind(h);
      },
      &context);
}

/// The sum of the corner normals of a wedge, and what else its corners say.
struct WedgeSum {
  Vec3 sum{0}, first{0}, by_area{0};
  bool all_alike = true, on_contour = false;

  void add(const TriMesh& mesh, const ProxyDraft& draft, HalfEdge h) {
    const auto corner = static_cast<std::size_t>(h);
    const Vec3& n = draft.corner_normal[corner];
    on_contour |= !draft.corner_on_contour.empty() && draft.corner_on_contour[corner] != 0;
    by_area += mesh.area(face_of(h)) * mesh.normal(face_of(h));
    if (n == Vec3(0)) return;
    if (first == Vec3(0)) first = n;
    all_alike = all_alike && n == first;
    sum += n;
  }
  bool none() const { return first == Vec3(0); }
  Vec3 normal() const {
    if (none()) return normalize_or(by_area, Vec3(0, 0, 1));
    return all_alike ? first : normalize_or(sum, first);  // the mean of equals, bit for bit
  }
};

void mean_normals(ProxyMesh& proxy, const ProxyDraft& draft, const Corners& corners,
                  const RunContext& context) {
  proxy.wedge_normal.resize(proxy.wedge_vertex.size());
  proxy.on_contour.assign(proxy.wedge_vertex.size(), 0);
  parallel_for(
      proxy.wedge_vertex.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t w = begin; w < end; ++w) {
          WedgeSum sum;
          for (const HalfEdge h : corners[proxy.wedge_vertex[w]]) {
            if (wedge_of(proxy, h) == w) sum.add(proxy.mesh, draft, h);
          }
          proxy.wedge_normal[w] = sum.normal();
          proxy.on_contour[w] = sum.on_contour || sum.none();
        }
      },
      &context);
}

}  // namespace

ProxyMesh assemble_proxy(ProxyDraft draft, const RunContext& context) {
  ProxyMesh proxy;
  proxy.mesh = std::move(draft.mesh);
  proxy.topology.opposite = find_opposites(proxy.mesh, context);
  const Corners corners = corners_at(proxy.mesh.triangles, proxy.mesh.positions.size());
  find_edge_kinds(proxy, draft, context);
  // Floods are serial: they run beside the rest, which does not need them.
  parallel_invoke(
      [&] {
        find_regions(proxy);
        find_components(proxy.topology);
      },
      [&] {
        find_wedges(proxy, corners, context);
        mean_normals(proxy, draft, corners, context);
      });
  find_sagitta(proxy, corners, context);
  proxy.source_face = std::move(draft.source_face);
  proxy.source_edge = std::move(draft.source_edge);
  proxy.seam = std::move(draft.seam);
  proxy.tolerance = draft.tolerance;
  return proxy;
}

}  // namespace burin
