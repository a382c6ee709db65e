#include <burin/base/parallel_filter.h>

#include "build_steps.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace burin {

namespace {

/// Longest chain without a loop, in edges, that counts as a hair.
constexpr std::uint32_t kHair = 6;
/// Most edges of a group of creases that may be a speck of noise.
constexpr std::uint32_t kSpeck = 24;
/// Mean bend of the smooth edges around a speck, as a share of the crease angle; and the share of
/// it that is left when convex and concave bends cancel. Form bends one way, noise both ways.
constexpr double kRough = 1.0 / 6, kOneSided = 0.5;
/// Most edges around a speck, as a share, that are flat within an angle of so many radians: facets
/// of form come in coplanar triangles, noise leaves none.
constexpr double kFlatShare = 0.15, kFlatTensor = 0.01;

/// CreaseGroups of vertices joined by creases.
class CreaseGroups {
 public:
  explicit CreaseGroups(std::size_t vertices) : parent_(vertices), group_(vertices) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    ++group_[a].edges;
    if (a == b) {
      group_[a].loop = true;
      return;
    }
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    Group &into = group_[a], &from = group_[b];
    into.edges += from.edges;
    into.loop = into.loop || from.loop;
  }

  void touch_boundary(std::uint32_t v) { group_[root(v)].boundary = true; }

  void add_bend(std::uint32_t v, double bend) {
    Group& g = group_[root(v)];
    g.bend += bend;
    g.absolute_bend += std::abs(bend);
    g.flats += std::abs(bend) < kFlatTensor;
    ++g.bends;
  }

  bool is_small(std::uint32_t v) {
    const Group& g = group_[root(v)];
    return g.edges > 0 && g.edges <= kSpeck && !g.boundary;
  }

  bool is_noise(std::uint32_t v, double crease_angle) {
    if (!is_small(v)) return false;
    const Group& g = group_[root(v)];
    if (!g.loop && g.edges <= kHair) return true;
    return g.absolute_bend > kRough * crease_angle * g.bends &&
           std::abs(g.bend) < kOneSided * g.absolute_bend && g.flats <= kFlatShare * g.bends;
  }

 private:
  struct Group {
    std::uint32_t edges = 0;
    bool loop = false, boundary = false;
    double bend = 0, absolute_bend = 0;  // radians, of the smooth edges around
    double bends = 0, flats = 0;         // how many of these there are
  };

  std::uint32_t root(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  std::vector<std::uint32_t> parent_;
  std::vector<Group> group_;
};

/// Creases and boundaries, each edge once, in ascending order.
std::vector<HalfEdge> sharp_edges(const ProxyMesh& proxy, const RunContext& context) {
  const auto sharp = [&](HalfEdge h) {
    const auto i = static_cast<std::size_t>(h);
    return proxy.edge_kind[i] == EdgeKind::Boundary ||
           (proxy.is_crease(h) && h < proxy.topology.opposite[i]);
  };
  return parallel_filter<HalfEdge>(proxy.edge_kind.size(), 3 * kFaceGrain, sharp, context);
}

/// The angle between the triangles of `h`, positive at a convex edge.
double bend_at(const ProxyMesh& proxy, const std::vector<Vec3>& normals, HalfEdge h) {
  const HalfEdge o = proxy.topology.opposite[static_cast<std::size_t>(h)];
  const Vec3 turn = glm::cross(normals[face_of(h)], normals[face_of(o)]);
  const Vec3 along =
      proxy.mesh.positions[origin(proxy.mesh, o)] - proxy.mesh.positions[origin(proxy.mesh, h)];
  const double angle =
      std::atan2(glm::length(turn), glm::dot(normals[face_of(h)], normals[face_of(o)]));
  return std::copysign(angle, glm::dot(turn, along));
}

/// Tells small groups how the smooth edges at their vertices bend.
void measure_bends(const ProxyMesh& proxy, const std::vector<Vec3>& normals,
                   const std::vector<std::uint8_t>& small, CreaseGroups& groups) {
  for (std::size_t i = 0; i < proxy.edge_kind.size(); ++i) {
    const auto h = static_cast<HalfEdge>(i);
    if (proxy.edge_kind[i] != EdgeKind::Smooth || h > proxy.topology.opposite[i]) continue;
    const std::uint32_t a = origin(proxy.mesh, h), b = origin(proxy.mesh, next_in_face(h));
    if (!small[a] && !small[b]) continue;
    const double bend = bend_at(proxy, normals, h);
    if (small[a]) groups.add_bend(a, bend);
    if (small[b]) groups.add_bend(b, bend);
  }
}

}  // namespace

void prune_noise(ProxyMesh& proxy, const std::vector<Vec3>& normals, double crease_angle,
                 const RunContext& context) {
  const std::vector<HalfEdge> edges = sharp_edges(proxy, context);
  const auto each = [&](bool creases, const auto& visit) {
    for (const HalfEdge h : edges) {
      if (proxy.is_crease(h) == creases) {
        visit(h, origin(proxy.mesh, h), origin(proxy.mesh, next_in_face(h)));
      }
    }
  };
  if (std::ranges::none_of(edges, [&](HalfEdge h) { return proxy.is_crease(h); })) return;
  CreaseGroups groups(proxy.mesh.positions.size());
  each(true, [&](HalfEdge, std::uint32_t a, std::uint32_t b) { groups.join(a, b); });
  each(false, [&](HalfEdge, std::uint32_t a, std::uint32_t b) {
    groups.touch_boundary(a);
    groups.touch_boundary(b);
  });
  std::vector<std::uint8_t> small;
  each(true, [&](HalfEdge, std::uint32_t a, std::uint32_t b) {
    if (!groups.is_small(a)) return;
    if (small.empty()) small.assign(proxy.mesh.positions.size(), 0);
    small[a] = small[b] = 1;
  });
  if (small.empty()) return;
  measure_bends(proxy, normals, small, groups);
  std::vector<HalfEdge> noise;
  each(true, [&](HalfEdge h, std::uint32_t a, std::uint32_t) {
    if (groups.is_noise(a, crease_angle)) noise.push_back(h);
  });
  for (const HalfEdge h : noise) {
    const auto i = static_cast<std::size_t>(h);
    proxy.edge_kind[i] = EdgeKind::Smooth;
    proxy.edge_kind[static_cast<std::size_t>(proxy.topology.opposite[i])] = EdgeKind::Smooth;
  }
}

}  // namespace burin
