#pragma once
// Parts as triangles, for what is measured; internal to the module.

#include <burin/base/error.h>
#include <burin/base/run_context.h>
#include <burin/surface/scene.h>
#include <burin/surface/surface.h>

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

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

  /// Model mm.
  double tolerance() const { return options_.tolerance; }

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

/// One a part; null where it is not in `drawn`, and where nothing of it is left or it cannot be
/// drawn, which the drawing tells.
inline std::vector<std::shared_ptr<const Surface>> surfaces_of(const Scene& scene,
                                                               const std::vector<bool>& drawn,
                                                               RealisedForms& forms) {
  std::vector<std::shared_ptr<const Surface>> out(scene.parts.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (!drawn[i]) continue;
    try {
      out[i] = forms.surface(scene.parts[i].form);
    } catch (const GeometryError&) {
      continue;
    }
  }
  return out;
}

}  // namespace burin::detail
