#pragma once
/// A surface that ends at the planes of a region, closed there by flat faces; internal to the
/// module.

#include <burin/surface/surface.h>

#include "cut_proxy.h"

#include <memory>
#include <optional>
#include <vector>

namespace burin::detail {

class CutSurface final : public Surface {
 public:
  CutSurface(std::shared_ptr<const Surface> whole, CutProxy cut, CutRegion region);

  MarchStep march(const SurfacePoint& from, Vec3 tangent, double length) const override;
  Frame frame(const SurfacePoint& point) const override;
  const ProxyMesh& proxy() const override { return proxy_; }
  ProxyPoint to_proxy(const SurfacePoint& point) const override;
  SurfacePoint lift(const ProxyPoint& point) const override;
  bool exact() const override { return whole_->exact(); }
  bool holds_for_coarser() const override { return whole_->holds_for_coarser(); }
  std::optional<Vec2> parameters(const SurfacePoint& point) const override {
    if (closes(point.triangle)) return std::nullopt;
    return whole_->parameters(inner(point));
  }
  Vec3 drawn_position(const SurfacePoint& point) const override;

 private:
  bool closes(std::uint32_t triangle) const { return pieces_[triangle].facet == kNoFacet; }
  /// Model mm inside what was taken away; minus at least that far from it.
  double beyond(Vec3 p) const;
  Vec3 normal_of(std::uint32_t closing) const {
    return region_[static_cast<std::size_t>(pieces_[closing].plane)].normal;
  }
  /// A point of this surface as the whole one has it.
  SurfacePoint inner(SurfacePoint point) const;
  /// The piece of a facet that holds a place of it, or is the nearest; the least barycentric
  /// coordinate there, minus infinity where the facet is gone.
  double locate(std::uint32_t facet, Vec3 bary, ProxyPoint& out) const;
  /// Whether the end of a march lies on this surface; then it becomes a point of it.
  bool adopt(SurfacePoint& end) const;
  /// Where a chord is in the middle of what was taken away, as a share of it; nothing where it
  /// stays out.
  std::optional<double> inside_of_chord(Vec3 from, Vec3 to) const;
  /// As far as the planes, or `length`, which does not lead over it and back.
  MarchStep march_to_cut(const SurfacePoint& from, Vec3 tangent, double length) const;
  MarchStep march_flat(const SurfacePoint& from, Vec3 tangent, double length) const;

  std::shared_ptr<const Surface> whole_;
  ProxyMesh proxy_;
  std::vector<FacetPiece> pieces_;
  std::vector<std::uint32_t> first_;  // of each facet of the whole, its pieces
  CutRegion region_;
};

}  // namespace burin::detail
