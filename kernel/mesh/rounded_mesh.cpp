#include <burin/mesh/rounded_mesh.h>
#include <burin/mesh/tips.h>

#include "build_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace burin {

namespace {

// The bulge that an edge may have, as a share of the shortest edge at its ends, by three: a smooth
// surface sampled evenly turns by at most the crease angle over an edge, which is a bulge of about
// 0.07 edges. Where facets are long and thin (a cone as CAD programs export it) the normals at a
// faint kink would bend the long edges far outward: there the bulge is that of the fine direction.
constexpr double kMostLift = 3 * 0.15;

/// Sine of the angle between the sides of a crease from which their planes tell its direction, and
/// cosine of the angle to its chord up to which that is believed: half the turn of a curve of a few
/// edges, where a sliver's plane may be any.
constexpr double kSharp = 0.25, kAlong = 0.9;
/// How much longer than the shortest edge at its ends an edge is long: it is bent where it bends at
/// both ends. A straight edge of a fillet whose normals lean at one end, to a corner, is not.
constexpr double kLong = 6;

/// The point over a share of an edge, from the lower vertex on; lifts at its start and its end.
Vec3 over_edge(const TriMesh& mesh, HalfEdge h, const Vec3& ahead, const Vec3& back, double t) {
  const std::uint32_t a = origin(mesh, h), b = origin(mesh, next_in_face(h));
  const Vec3 &p = mesh.positions[std::min(a, b)], &q = mesh.positions[std::max(a, b)];
  const Vec3 &low = a < b ? ahead : back, &high = a < b ? back : ahead;
  return p + t * (q - p) + t * (1 - t) * ((1 - t) * low + t * high);
}

/// Whether a smooth edge begins, or ends, at a tip.
bool is_tip(const ProxyMesh& proxy, HalfEdge h, bool at_origin) {
  const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(h)];
  return !one_wedge_at(proxy, at_origin ? h : o);
}

}  // namespace

RoundedMesh::RoundedMesh(const ProxyMesh& proxy, std::span<const std::uint8_t> exact)
    : proxy_(&proxy),
      exact_(exact),
      finest_(proxy.mesh.positions.size(), std::numeric_limits<float>::max()) {
  const TriMesh& mesh = proxy.mesh;
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[f][k], b = mesh.triangles[f][(k + 1) % 3];
      const auto length = static_cast<float>(glm::distance(mesh.positions[a], mesh.positions[b]));
      finest_[a] = std::min(finest_[a], length);
      finest_[b] = std::min(finest_[b], length);
    }
  }
}

bool RoundedMesh::is_exact(HalfEdge h) const {
  if (exact_.empty()) return false;
  const HalfEdge o = proxy_->topology.opposite[static_cast<std::size_t>(h)];
  return exact_[face_of(h)] != 0 || (o != kNoHalfEdge && exact_[face_of(o)] != 0);
}

// What the control point of the edge's cubic beside one of its ends is off the straight edge, times
// three: the edge projected onto the plane of the wedge's normal, or at a crease onto the line that
// this shares with the plane across. The same bits for both half-edges.
Vec3 RoundedMesh::control_lift(HalfEdge h, bool at_origin) const {
  if (is_exact(h)) return Vec3(0);
  const ProxyMesh& proxy = *proxy_;
  const EdgeKind kind = proxy.edge_kind[static_cast<std::size_t>(h)];
  const HalfEdge there = next_in_face(h);
  const auto normal = [&](HalfEdge corner) -> const Vec3& {
    return proxy.wedge_normal[wedge_of(proxy, corner)];
  };
  std::uint32_t a = origin(proxy.mesh, h), b = origin(proxy.mesh, there);
  if (!at_origin) std::swap(a, b);
  const Vec3 edge = proxy.mesh.positions[b] - proxy.mesh.positions[a];
  const Vec3& n = normal(at_origin ? h : there);
  const double finest = std::min(finest_[a], finest_[b]), most = kMostLift * finest;
  if (kind == EdgeKind::Smooth || kind == EdgeKind::Boundary) {
    // From a tip the surface runs straight; the triangles at it have no normal in common.
    const auto tip = [&](bool here) { return kind == EdgeKind::Smooth && is_tip(proxy, h, here); };
    if (tip(at_origin)) return Vec3(0);
    double lift = -glm::dot(edge, n);
    if (glm::dot(edge, edge) > kLong * kLong * finest * finest) {
      const double other = tip(!at_origin) ? 0 : glm::dot(edge, normal(at_origin ? there : h));
      if ((lift < 0) != (other < 0)) return Vec3(0);
      if (std::abs(other) < std::abs(lift)) lift = other;
    }
    return std::clamp(lift, -most, most) * n;
  }
  const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(h)];
  const Vec3 line = glm::cross(n, normal(at_origin ? next_in_face(o) : o));
  const double size = glm::dot(line, line), along = glm::dot(edge, line);
  if (size < kSharp * kSharp || along * along < kAlong * kAlong * size * glm::dot(edge, edge)) {
    return Vec3(0);
  }
  const Vec3 lift = along / size * line - edge;
  const double length = glm::length(lift);
  return length > most ? most / length * lift : lift;
}

RoundedFacet RoundedMesh::facet(std::uint32_t face) const {
  RoundedFacet out(*proxy_, face);
  Vec3 sum(0);
  for (int k = 0; k < 3; ++k) {
    const auto h = static_cast<HalfEdge>(3 * face) + k;
    out.ahead_[k] = control_lift(h, true);
    out.back_[k] = control_lift(h, false);
    sum += out.ahead_[k] + out.back_[k];
  }
  // The inner control point lies half as far again off the triangle as the mean of the six on the
  // edges: each of those is a third of its lift off.
  out.inner_ = 1.5 * sum / 18.0;
  return out;
}

Vec3 RoundedMesh::on_edge(HalfEdge h, double t) const {
  return over_edge(proxy_->mesh, h, control_lift(h, true), control_lift(h, false), t);
}

Vec3 RoundedFacet::on_edge(std::size_t k, double t) const {
  return over_edge(proxy_->mesh, static_cast<HalfEdge>(3 * face_ + k), ahead_[k], back_[k], t);
}

Vec3 RoundedFacet::at(Vec3 bary) const {
  Vec3 off(0);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    off += bary[i] * bary[j] * (bary[i] * ahead_[i] + bary[j] * back_[i]);
  }
  return proxy_->position(face_, bary) + off + 6 * bary.x * bary.y * bary.z * inner_;
}

Vec3 RoundedFacet::normal_at(Vec3 bary) const {
  const Triangle& t = proxy_->mesh.triangles[face_];
  Vec3 along[3];  // the derivatives by the coordinates
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double bi = bary[i], bj = bary[j], bk = bary[k];
    along[i] = proxy_->mesh.positions[t[static_cast<std::size_t>(i)]] +
               bj * (2 * bi * ahead_[i] + bj * back_[i]) +
               bk * (bk * ahead_[k] + 2 * bi * back_[k]) + 6 * bj * bk * inner_;
  }
  return glm::cross(along[1] - along[0], along[2] - along[0]);
}

}  // namespace burin
