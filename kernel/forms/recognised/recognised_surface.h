#pragma once
// The surface behind RecognisedForm.

#include <burin/base/affine.h>
#include <burin/surface/surface.h>

#include "recognise.h"

#include <memory>
#include <vector>

namespace burin::recognised {

/// A mesh surface whose triangles know the round surface that they approximate.
class RecognisedSurface final : public Surface {
 public:
  /// `patch`: for each triangle its patch, or -1. The mesh stands where `placement` takes the
  /// patches.
  RecognisedSurface(std::shared_ptr<const Surface> mesh, std::shared_ptr<const Recognised> round,
                    std::vector<std::int32_t> patch, const Placement& placement)
      : mesh_(std::move(mesh)),
        round_(std::move(round)),
        patch_(std::move(patch)),
        place_(placement),
        back_(inverse(placement)) {}

  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override {
    return mesh_->march(from, tangent, length);
  }
  Frame frame(const SurfacePoint& point) const override;
  bool exact() const override { return true; }
  const ProxyMesh& proxy() const override { return mesh_->proxy(); }
  ProxyPoint to_proxy(const SurfacePoint& point) const override { return mesh_->to_proxy(point); }
  SurfacePoint lift(const ProxyPoint& point) const override { return mesh_->lift(point); }
  Vec3 drawn_position(const SurfacePoint& point) const override;
  std::vector<Frame> wedge_frames(const RunContext& context) const override;

 private:
  Frame frame_of(const Patch& patch, Vec3 position) const;
  const Patch* patch_at(std::uint32_t triangle) const {
    const std::int32_t p = patch_[triangle];
    return p < 0 ? nullptr : &round_->patches[static_cast<std::size_t>(p)];
  }

  std::shared_ptr<const Surface> mesh_;
  std::shared_ptr<const Recognised> round_;
  std::vector<std::int32_t> patch_;
  Placement place_, back_;
};

}  // namespace burin::recognised
