#pragma once
/// The surface behind MeshForm.

#include <burin/mesh/curvature.h>
#include <burin/mesh/rounded_mesh.h>
#include <burin/surface/surface.h>

#include <mutex>
#include <optional>
#include <vector>

namespace burin {

/// The curvature tensor at a wedge in the TangentBasis of the wedge's normal: `mean` times the
/// identity plus the deviator, (k1-k2)/2 at twice the angle of d1 as a complex number. 32 bytes,
/// and interpolation is linear.
struct WedgeTensor {
  double mean = 0;
  Vec2 deviator{0};
  double confidence = 0;
};

/// A proxy mesh that is itself the form.
class MeshSurface final : public Surface {
 public:
  /// `curvature` has one entry a wedge, or none where no curvature was asked for. `fine`: the
  /// triangles lie as near to the surface that they stand for as the drawing can show.
  MeshSurface(ProxyMesh proxy, const std::vector<Curvature>& curvature, bool fine = false);

  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override;
  Frame frame(const SurfacePoint& point) const override;
  const ProxyMesh& proxy() const override { return proxy_; }
  ProxyPoint to_proxy(const SurfacePoint& point) const override {
    return {point.triangle, point.coords};
  }
  SurfacePoint lift(const ProxyPoint& point) const override {
    return {0, point.bary, proxy_.position(point.face, point.bary), point.face};
  }
  std::vector<Frame> wedge_frames(const RunContext& context) const override;
  Vec3 drawn_position(const SurfacePoint& point) const override;
  bool holds_for_coarser() const override { return !fine_; }

 private:
  ProxyMesh proxy_;
  bool fine_;
  // Made when the first stroke is drawn: outlines do without.
  mutable std::once_flag rounding_;
  mutable std::optional<RoundedMesh> rounded_;
  std::vector<WedgeTensor> tensors_;
};

}  // namespace burin
