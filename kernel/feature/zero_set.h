#pragma once
// A function over the wedges of a proxy, and where it is zero.

#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/mesh/proxy_mesh.h>
#include <burin/mesh/rounded_mesh.h>

#include <cstdint>
#include <vector>

namespace burin {

/// The place at a share of an edge, in the triangle that its half-edge belongs to.
inline Vec3 bary_on(HalfEdge h, double share) {
  Vec3 bary(0);
  bary[static_cast<int>(h % 3)] = 1 - share;
  bary[static_cast<int>(next_in_face(h) % 3)] = share;
  return bary;
}

/// A point where g is zero, on the edge of half-edge h.
struct ZeroCrossing {
  Vec3 position{0};
  /// Share of the edge from the half-edge's own origin, in [0,1].
  double share = 0;
  /// The same from the other end, bit for bit what the half-edge beyond has.
  double share_beyond = 1;
};

/// g at every wedge of one part. Where it is positive is its front side; zero is none.
class ZeroSet {
 public:
  /// g is zero all over, until a derived class has set it.
  ZeroSet(const ProxyMesh& proxy, const Camera& camera)
      : proxy_(&proxy), camera_(&camera), surface_(proxy), g_(proxy.wedge_normal.size()) {}
  virtual ~ZeroSet() = default;
  ZeroSet(const ZeroSet&) = delete;
  ZeroSet& operator=(const ZeroSet&) = delete;

  const ProxyMesh& proxy() const { return *proxy_; }
  const Camera& camera() const { return *camera_; }
  double g(std::uint32_t wedge) const { return g_[wedge]; }
  /// Whether the corner at the origin of `h` is on the front side, as the triangle of `h` has it.
  bool front_at(HalfEdge h) const {
    if (decided(face_of(h))) return decided_[face_of(h)] > 0;
    return front(origin_wedge(h));
  }
  /// Whether a triangle is on one side as a whole, whatever g is at its corners: no zero runs
  /// across it.
  bool decided(std::uint32_t face) const { return !decided_.empty() && decided_[face] != 0; }

  std::uint32_t origin_wedge(HalfEdge h) const {
    return proxy_->wedges[face_of(h)][static_cast<std::size_t>(h % 3)];
  }
  std::uint32_t target_wedge(HalfEdge h) const { return origin_wedge(next_in_face(h)); }
  /// Whether g changes its sign along `h`, in the triangle of `h`.
  bool crosses(HalfEdge h) const { return front_at(h) != front_at(next_in_face(h)); }
  /// The zero on a half-edge that crosses; bit for bit the same from both sides of a smooth edge.
  ZeroCrossing crossing(HalfEdge h) const;
  /// Triangles with corners of both signs, ascending.
  std::vector<std::uint32_t> mixed_faces(const RunContext& context) const;
  /// The smooth surface over a triangle; on an edge it passes through `crossing`.
  RoundedFacet over(std::uint32_t face) const { return surface_.facet(face); }
  /// The point of the zero between two on the edges of a triangle, next to a place of that.
  virtual Vec3 between(const RoundedFacet& facet, Vec3 bary) const { return facet.at(bary); }
  /// Whether the zero between two edges is straight over the triangle.
  virtual bool is_straight() const { return true; }
  /// Whether it is straight over one triangle where it is of a length (paper mm).
  virtual bool is_straight(std::uint32_t /*face*/, double /*length*/) const { return false; }
  /// Unit normal on `h` (in its triangle) at a share of it.
  Vec3 normal(HalfEdge h, double share) const;

 protected:
  bool front(std::uint32_t wedge) const { return g_[wedge] > 0; }
  /// The share of the way from wedge `a` to `b`, of different signs, at which g is zero: as if it
  /// were linear. They are the ends of `h`.
  virtual double zero_share(std::uint32_t a, std::uint32_t b, HalfEdge /*h*/) const {
    return g_[a] / (g_[a] - g_[b]);
  }
  /// The point of the surface at a share of an edge, from the lower of its vertices on.
  virtual Vec3 on_edge(HalfEdge h, double t) const { return surface_.on_edge(h, t); }

  const ProxyMesh* proxy_;
  const Camera* camera_;
  RoundedMesh surface_;
  std::vector<double> g_;
  /// For each triangle 1 or -1 where it is decided, by its side; empty where none is.
  std::vector<std::int8_t> decided_;
};

}  // namespace burin
