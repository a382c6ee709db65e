#pragma once
/// Untrimmed patches as a form: Bezier, B-spline and NURBS surfaces, or any S(u,v).

#include <burin/forms/charted/chart.h>
#include <burin/surface/scene.h>

#include <memory>
#include <vector>

namespace burin {

/// A part of one or more patches, each over its whole domain. Sides that coincide in space (within
/// `weld` of the part's size) are one edge, whichever way and how fast their parameters run, and a
/// side that closes on another of the same patch is a seam; collapsed sides are poles (loops of
/// control points within 5e-4 of the size, too). Patches are cut where they have kinks inside,
/// which then are sharp edges, and count as several faces. Patches that meet are oriented alike,
/// and outwards where they close. Edges are sharp from 1 degree between the normals.
class ParametricForm final : public Form {
 public:
  explicit ParametricForm(std::vector<std::shared_ptr<const Chart>> patches, double weld = 1e-7,
                          const Placement& placement = {});
  ~ParametricForm() override;

  /// Not yet placed.
  const std::vector<std::shared_ptr<const Chart>>& patches() const { return patches_; }
  Box3 bounds(const Mat3& axes) const override;
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override;
  std::shared_ptr<const Form> mapped(const Placement& by) const override;
  bool realised_beside_others() const override { return true; }

 private:
  std::vector<std::shared_ptr<const Chart>> patches_;
  double weld_;
  Placement placement_;
};

}  // namespace burin
