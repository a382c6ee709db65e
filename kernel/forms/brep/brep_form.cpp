#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>
#include <burin/forms/brep/realise_faces.h>

#include "measure_shape.h"

#include <cmath>

namespace burin {

BrepForm::BrepForm(std::shared_ptr<const BrepModel> model, const Placement& placement)
    : model_(std::move(model)), placement_(placement) {}
BrepForm::~BrepForm() = default;

Box3 BrepForm::bounds(const Mat3& axes) const {
  Box3 box = model_->bounds(axes * placement_.linear);
  const Vec3 shift = axes * placement_.offset;
  box.min += shift;
  box.max += shift;
  return box;
}

std::shared_ptr<const Surface> BrepForm::realise(const RealiseOptions& options,
                                                 RunContext& context) const {
  context.begin_stage(RunStage::Build);
  if (!is_invertible(placement_)) throw GeometryError("the placement of a part has no extent");
  const std::shared_ptr<const BrepTriangles> mesh =
      model_->tessellate(options.tolerance / stretch(placement_), context, options.diagnostics);
  const double size =
      is_similar(placement_) ? placement_.scale() * model_->size() : bounds(Mat3(1)).diagonal();
  const PlacedAtlas atlas{model_, placement_, size};
  auto surface = realise_faces(atlas, *mesh, mesh->loose, options, context);
  context.end_stage();
  return surface;
}

std::shared_ptr<const Form> BrepForm::mapped(const Placement& by) const {
  return std::make_shared<BrepForm>(model_, after(by, placement_));
}

Definition BrepForm::definition() const { return {model_.get(), placement_.linear}; }

ShapeMeasure BrepForm::measure(RunContext& context) const {
  context.check();
  if (!is_similar(placement_)) return brep_measure(*model_, placement_);
  return brep_measure(*model_).scaled(placement_.scale(), placement_.mirrors());
}

BrepCounts count(const BrepModel& model) { return model.counts(); }

}  // namespace burin
