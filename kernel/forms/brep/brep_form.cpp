#include <burin/base/error.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>

namespace burin {

BrepForm::BrepForm(std::shared_ptr<const BrepModel> model, const Placement& placement)
    : model_(std::move(model)), placement_(placement) {}
BrepForm::~BrepForm() = default;

Box3 BrepForm::bounds(const Mat3& axes) const { return model_->bounds(axes * placement_.linear); }

std::shared_ptr<const Surface> BrepForm::realise(const RealiseOptions&, RunContext&) const {
  throw GeometryError("no surface yet");
}

BrepCounts count(const BrepModel& model) { return model.counts(); }

}  // namespace burin
