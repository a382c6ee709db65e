#pragma once
/// What the cut along contours asks of a form.

#include <burin/surface/surface.h>

#include <cstddef>
#include <cstdint>

namespace burin {

/// A place on the exact surface of a face and how it goes on from there: the partial derivatives
/// of the position and of the unit normal (these only where the surface is regular: the cross
/// product of `u` and `v` is not zero).
struct SurfaceSample {
  Vec3 position{0}, normal{0};
  Vec3 u{0}, v{0}, normal_u{0}, normal_v{0};
};

/// The faces of a ChartMesh as exact surfaces over their parameters (u,v), in place. Every function
/// may be called from many threads.
class Sampler {
 public:
  Sampler() = default;
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;
  virtual ~Sampler() = default;

  virtual std::size_t face_count() const = 0;
  virtual FaceKind kind(std::int32_t face) const = 0;
  /// Size of the domain in u and v, and the length of the period (0 = not periodic).
  virtual Vec2 domain_size(std::int32_t face) const = 0;
  virtual Vec2 period(std::int32_t face) const = 0;
  virtual SurfaceSample sample(std::int32_t face, Vec2 uv) const = 0;
  /// The point of a use of a model edge (ChartMesh::Border) at the edge's parameter t, in (u,v) of
  /// its face. The uses of one edge meet in space there.
  virtual Vec2 on_coedge(std::int32_t coedge, double t) const = 0;
};

}  // namespace burin
