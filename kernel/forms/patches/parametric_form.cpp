#include <burin/base/affine.h>
#include <burin/base/error.h>
#include <burin/contour_cut/contour_cut.h>
#include <burin/forms/charted/atlas_sampler.h>
#include <burin/forms/charted/charted_surface.h>
#include <burin/forms/charted/place_mesh.h>
#include <burin/forms/charted/refine.h>
#include <burin/forms/charted/wedge_normals.h>
#include <burin/forms/patches/parametric_form.h>

#include "tessellate.h"

#include <fmt/format.h>

#include <utility>

namespace burin {

ParametricForm::ParametricForm(std::vector<std::shared_ptr<const Chart>> patches, double weld,
                               const Placement& placement)
    : patches_(std::move(patches)), weld_(weld), placement_(placement) {}

ParametricForm::~ParametricForm() = default;

std::shared_ptr<const Form> ParametricForm::mapped(const Placement& by) const {
  return std::make_shared<ParametricForm>(patches_, weld_, after(by, placement_));
}

std::shared_ptr<const Surface> ParametricForm::realise(const RealiseOptions& options,
                                                       RunContext& context) const {
  if (patches_.empty()) throw GeometryError("a parametric form without patches");
  context.begin_stage(RunStage::Build);
  context.check();
  const detail::PatchComplex complex = detail::weld(patches_, weld_, context);
  if (complex.contradictions > 0 && options.diagnostics) {
    options.diagnostics->add(
        Severity::Warning, "parametric.one_sided", complex.contradictions,
        fmt::format("{} common sides of patches would make the surface one-sided; left open",
                    complex.contradictions));
  }
  detail::Tessellation made =
      detail::tessellate(complex, options.tolerance / stretch(placement_), context);
  ChartMesh mesh = placement_.moves() ? placed(made.mesh, placement_) : std::move(made.mesh);
  if (!made.complete && options.diagnostics) {
    add_triangles_bounded(*options.diagnostics, mesh.triangles.size(), mesh.tolerance,
                          options.tolerance);
  }
  const double size = placement_.moves() ? bounds(Mat3(1)).diagonal() : complex.size;
  const PlacedAtlas atlas{complex.atlas, placement_, size};
  set_wedge_normals(mesh, atlas, context);
  const bool found =
      !options.view || cut_along_contours(mesh, AtlasSampler(atlas), *options.view, {}, context);
  if (!found && options.diagnostics) add_contours_bounded(*options.diagnostics);
  auto surface = make_charted_surface(atlas, std::move(mesh), context);
  context.end_stage();
  return surface;
}

}  // namespace burin
