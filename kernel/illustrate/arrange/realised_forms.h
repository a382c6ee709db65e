#pragma once
// Parts as triangles, for what is measured; internal to the module.

#include <burin/base/run_context.h>
#include <burin/surface/scene.h>
#include <burin/surface/surface.h>

#include <map>
#include <memory>

namespace burin::detail {

/// Forms as they are realised to be measured, each once.
class RealisedForms {
 public:
  /// `diagonal`: of what is drawn, model mm.
  RealisedForms(double diagonal, RunContext& context) : context_(context) {
    // About as for a sheet, so that faces have the numbers that a drawing gives them.
    constexpr double kFine = 2e-4;
    if (diagonal > 0) options_.tolerance = kFine * diagonal;
    options_.curvature = false;
  }

  /// Throws as Form::realise.
  const std::shared_ptr<const Surface>& surface(const std::shared_ptr<const Form>& form) {
    std::shared_ptr<const Surface>& made = made_[form];
    if (!made) made = form->realise(options_, context_);
    return made;
  }

 private:
  RealiseOptions options_;
  RunContext& context_;
  std::map<std::shared_ptr<const Form>, std::shared_ptr<const Surface>> made_;
};

}  // namespace burin::detail
