#pragma once
// From the forms of a scene to surfaces; internal to the module.

#include <burin/base/diagnostics.h>
#include <burin/base/run_context.h>
#include <burin/camera/camera.h>
#include <burin/illustrate/illustrate.h>
#include <burin/surface/scene.h>

#include "occluders.h"
#include "part_styles.h"

#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <vector>

namespace burin::detail {

/// Model mm: as asked for, or what the sheet shows.
double chord_tolerance(const Scene& scene, const Camera& camera, const IllustrateOptions& options);

/// The surfaces of a drawing, kept for the next one.
class RealisedParts {
 public:
  /// One a part; empty ones of those that are not drawn or that could not be realised, of which the
  /// diagnostics tell. Surfaces that the last drawing has made of the same forms in the same way
  /// are taken again. Throws the first GeometryError where no part could be realised.
  Surfaces realise(const Scene& scene, const Camera& camera, const PartStyles& part_styles,
                   const IllustrateOptions& options, Diagnostics& diagnostics, RunContext& context);

 private:
  struct Made {
    std::shared_ptr<const Form> form;
    double tolerance = 0, crease_angle = 0;
    bool curvature = false;
    std::optional<Camera> view{};  // of forms that look at it
    std::shared_ptr<const Surface> surface{};
    Diagnostics said{};
  };
  /// `kept`: of the part with the same number in the last drawing.
  static Made made(std::optional<Made> kept, const std::shared_ptr<const Form>& form,
                   const RealiseOptions& options, RunContext& context);
  /// What is asked of a part.
  struct Asked {
    RealiseOptions options;
    std::exception_ptr failed{};
  };
  /// Puts a part into `made_`; a GeometryError into `asked`.
  void make(const Part& part, std::size_t i, Asked& asked, RunContext& context);
  /// The parts that are drawn.
  struct Groups {
    /// To be realised one after the other.
    std::vector<std::size_t> alone;
    /// Those of one shape are a group; groups may be realised at the same time.
    std::vector<std::vector<std::size_t>> together;
  };
  static Groups groups_of(const Scene& scene, const PartStyles& part_styles);
  void make_all(const Scene& scene, const PartStyles& part_styles, std::vector<Asked>& asked,
                RunContext& context);

  /// One a part; nothing of those without a surface.
  std::vector<std::optional<Made>> made_;
};

}  // namespace burin::detail
