#pragma once
/// Trimmed faces and solids of a CAD part as a form (OCCT behind it).

#include <burin/forms/charted/chart.h>
#include <burin/surface/scene.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace burin {

/// A shape as it was read; shared by all its instances.
class BrepModel;

/// One instance of a shape. Faces become charts (planes, cylinders, cones, spheres and tori keep
/// their analytic form, the rest is B-spline or evaluated by OCCT), numbered like the faces of the
/// shape; edges likewise. The tessellation comes from OCCT's mesher at the tolerance asked for, its
/// nodes on edges shared by both faces; it is made once per tolerance and shared by the instances.
/// Faces that cannot be meshed are left out, each named by its number in a diagnostic.
class BrepForm final : public Form {
 public:
  BrepForm(std::shared_ptr<const BrepModel> model, const Placement& placement);
  ~BrepForm() override;

  const BrepModel& model() const { return *model_; }
  const Placement& placement() const { return placement_; }
  Box3 bounds(const Mat3& axes) const override;
  /// Throws GeometryError where no face can be realised.
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override;
  std::shared_ptr<const Form> mapped(const Placement& by) const override;
  Definition definition() const override;
  /// By integration over the exact faces; over their splines where it is stretched.
  ShapeMeasure measure(RunContext& context) const override;

 private:
  std::shared_ptr<const BrepModel> model_;
  Placement placement_;
};

/// One of several bodies of a part, and where it stands in the part.
struct BrepBody {
  std::shared_ptr<const BrepModel> model;
  Placement placement;
};

/// One instance of several bodies, such as the solids of a product: side by side, unjoined. Each
/// has a model that numbers its faces and edges on from the body before.
class BrepBodiesForm final : public Form {
 public:
  /// `bodies`: at least one; shared by all instances.
  BrepBodiesForm(std::shared_ptr<const std::vector<BrepBody>> bodies, const Placement& placement);
  ~BrepBodiesForm() override;

  const std::vector<BrepBody>& bodies() const { return *bodies_; }
  const Placement& placement() const { return placement_; }
  Box3 bounds(const Mat3& axes) const override;
  /// Bodies of which nothing can be drawn are named in a diagnostic ("brep.body_not_drawn"). Throws
  /// GeometryError where that is all of them.
  std::shared_ptr<const Surface> realise(const RealiseOptions& options,
                                         RunContext& context) const override;
  std::shared_ptr<const Form> mapped(const Placement& by) const override;
  Definition definition() const override;
  ShapeMeasure measure(RunContext& context) const override;

 private:
  std::shared_ptr<const std::vector<BrepBody>> bodies_;
  Placement placement_;
};

/// Counts of a shape, for `burin info`.
struct BrepCounts {
  std::int64_t solids = 0, shells = 0, faces = 0, edges = 0, free_edges = 0;
  bool closed = false;
};
BrepCounts count(const BrepModel& model);

/// Reads OCCT's BREP text or binary from memory. Throws InputError.
std::shared_ptr<const BrepModel> brep_from_text(const std::string& text);

}  // namespace burin
