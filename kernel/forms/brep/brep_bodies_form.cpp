#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>
#include <burin/surface/composite_surface.h>

#include "measure_shape.h"

#include <fmt/format.h>

#include <utility>

namespace burin {

BrepBodiesForm::BrepBodiesForm(std::shared_ptr<const std::vector<BrepBody>> bodies,
                               const Placement& placement)
    : bodies_(std::move(bodies)), placement_(placement) {}
BrepBodiesForm::~BrepBodiesForm() = default;

Box3 BrepBodiesForm::bounds(const Mat3& axes) const {
  Box3 box;
  for (const BrepBody& body : *bodies_) {
    box.add(BrepForm(body.model, after(placement_, body.placement)).bounds(axes));
  }
  return box;
}

std::shared_ptr<const Surface> BrepBodiesForm::realise(const RealiseOptions& options,
                                                       RunContext& context) const {
  std::vector<std::shared_ptr<const Surface>> surfaces;
  std::string first;
  for (std::size_t i = 0; i < bodies_->size(); ++i) {
    const BrepBody& body = (*bodies_)[i];
    try {
      const BrepForm form(body.model, after(placement_, body.placement));
      surfaces.push_back(form.realise(options, context));
    } catch (const GeometryError& e) {
      if (first.empty()) first = e.what();
      if (options.diagnostics == nullptr) continue;
      options.diagnostics->add(
          Severity::Error, "brep.body_not_drawn", 1,
          fmt::format("body {} of {} was left out: {}", i + 1, bodies_->size(), e.what()));
    }
  }
  if (surfaces.empty()) throw GeometryError(first);
  return make_composite_surface(std::move(surfaces));
}

Definition BrepBodiesForm::definition() const { return {bodies_.get(), placement_.linear}; }

std::shared_ptr<const Form> BrepBodiesForm::mapped(const Placement& by) const {
  return std::make_shared<BrepBodiesForm>(bodies_, after(by, placement_));
}

ShapeMeasure BrepBodiesForm::measure(RunContext& context) const {
  context.check();
  if (!is_similar(placement_)) {
    std::vector<BrepBody> stretched = *bodies_;
    for (BrepBody& body : stretched) body.placement = after(placement_, body.placement);
    return brep_measure(stretched);
  }
  return brep_measure(*bodies_).scaled(placement_.scale(), placement_.mirrors());
}

}  // namespace burin
