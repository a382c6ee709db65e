#pragma once
// What lines of equal light and regions ask of surfaces; internal to the module.

#include <burin/camera/camera.h>
#include <burin/feature/isophotes.h>
#include <burin/stroke/stroke.h>
#include <burin/surface/surface.h>

#include "occluders.h"

#include <cstdint>
#include <span>
#include <vector>

namespace burin::detail {

/// The places of an exact surface, which must outlive the answer; nothing of others, whose proxies
/// know as much.
ExactAt exact_places(const Surface& surface);

/// Where rays meet the surfaces of solid parts themselves; of meshes, what the normals at their
/// corners say of these. Triangles of two surfaces may lie before each other in turn where these
/// touch, as a ball and the pipe that it closes, or lie on each other.
class ExactDepths {
 public:
  /// The parts must outlive this. Cost: a pass over the triangles of meshes.
  explicit ExactDepths(const Occluders& occluders);

  /// Whether surfaces and triangles of different parts may lie behind each other in another order.
  bool needed() const { return proxies_.size() > 1; }
  /// Model mm along a ray from a place of a part within which they may.
  double reach(FaceRef where, Vec3 direction) const;
  /// Model mm along a ray by which depths of two places are not told apart: surfaces that lie on
  /// each other, as two cylinders of one radius and axis, have the same but for what tangent planes
  /// are off, and for the rounding of files.
  double flush(FaceRef a, FaceRef b, Vec3 direction) const;
  /// Whether the first of two parts is seen where they lie on each other.
  bool precedes(std::int32_t part, std::int32_t other) const;
  /// Model mm from an origin along a ray to where it meets the surface of a place that its triangle
  /// was met at, by the tangent plane there.
  double depth(FaceRef where, Vec3 bary, Vec3 position, Vec3 origin, Vec3 direction) const;

 private:
  double off(FaceRef where) const;
  double cosine(FaceRef where, Vec3 direction) const;
  ExactPlace place(FaceRef where, Vec3 bary) const;

  std::span<const ProxyMesh* const> proxies_;
  const std::vector<double>& ranks_;
  std::vector<ExactAt> places_;
  double most_off_ = 0, untold_ = 0;
};

/// What the viewer sees of the solid parts: where triangles of several lie as near, the part whose
/// surface itself is nearest, of those that lie on each other that of the highest rank. All must
/// outlive the answer. Cost: a ray, and where `depths` are needed a short one.
ViewProbe exact_view_probe(const Occluders& occluders, const ExactDepths& depths,
                           const Camera& camera);

}  // namespace burin::detail
