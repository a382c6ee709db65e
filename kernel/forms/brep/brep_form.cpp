#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/forms/brep/brep_form.h>
#include <burin/forms/brep/occt/brep_model.h>
#include <burin/forms/parametric/charted_surface.h>
#include <burin/forms/parametric/contour_cut.h>

#include "turn_triangles.h"

#include <cmath>

namespace burin {
namespace {

/// The triangles of a model at their place.
ChartMesh placed(const ChartMesh& mesh, const Placement& placement, double scale) {
  ChartMesh out = mesh;
  parallel_for(out.positions.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) out.positions[i] = placement.point(out.positions[i]);
  });
  if (placement.mirrors()) {
    std::int32_t faces = 0;
    for (const std::int32_t f : out.face) faces = std::max(faces, f + 1);
    turn_triangles(out, std::vector<std::uint8_t>(static_cast<std::size_t>(faces), 1));
  }
  out.tolerance *= scale;
  return out;
}

}  // namespace

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
  context.begin_stage("build");
  const double scale = std::cbrt(std::abs(glm::determinant(placement_.linear)));
  if (!(scale > 0)) throw GeometryError("the placement of a part has no extent");
  const std::shared_ptr<const ChartMesh> mesh =
      model_->tessellate(options.tolerance / scale, context, options.diagnostics);
  const PlacedAtlas atlas{model_, placement_, scale * model_->size()};
  ChartMesh realised = placed(*mesh, placement_, scale);
  set_wedge_normals(realised, atlas, context);
  if (options.view) cut_along_contours(realised, atlas, *options.view, {}, context);
  auto surface = make_charted_surface(atlas, std::move(realised), context);
  context.end_stage();
  return surface;
}

BrepCounts count(const BrepModel& model) { return model.counts(); }

}  // namespace burin
