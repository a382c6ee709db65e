#pragma once
/// An atlas as the cut along contours asks for it.

#include <burin/contour_cut/sampler.h>
#include <burin/forms/charted/atlas.h>

namespace burin {

/// Keeps a reference to the atlas.
class AtlasSampler final : public Sampler {
 public:
  explicit AtlasSampler(const PlacedAtlas& placed) : placed_(placed) {}

  std::size_t face_count() const override { return placed_.atlas->face_count(); }
  FaceKind kind(std::int32_t face) const override { return placed_.kind(face); }
  Vec2 domain_size(std::int32_t face) const override { return chart(face).domain().size(); }
  Vec2 period(std::int32_t face) const override { return chart(face).period(); }
  SurfaceSample sample(std::int32_t face, Vec2 uv) const override;
  Vec2 on_coedge(std::int32_t coedge, double t) const override {
    return placed_.atlas->on_coedge(coedge, t);
  }

 private:
  const Chart& chart(std::int32_t face) const { return placed_.atlas->chart(face); }

  const PlacedAtlas& placed_;
};

}  // namespace burin
