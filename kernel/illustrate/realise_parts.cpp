#include "realise_parts.h"

#include <burin/base/error.h>
#include <burin/field/catalogue.h>
#include <burin/surface/empty_surface.h>

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm that a tessellation chosen from the sheet may be off.
constexpr double kSheetTolerance = 0.05;

// Diagonals of the sheet that a drawing may be large before its surfaces are made no finer: what is
// beyond the sheet is made too.
constexpr double kMostSheets = 5;

// A word where a magnified drawing of curved surfaces is coarser than the sheet could show.
void tell_magnified(const Camera& camera, const Surfaces& surfaces, double tolerance,
                    Diagnostics& diagnostics) {
  const double on_paper = tolerance * camera.scale(), coarser = on_paper / kSheetTolerance;
  constexpr double kRounding = 1e-9;
  if (coarser <= 1 + kRounding) return;
  // The facets of meshes are as they are; what rounds them is no finer than this.
  if (std::all_of(surfaces.begin(), surfaces.end(),
                  [](const auto& s) { return s->proxy().tolerance == 0; })) {
    return;
  }
  diagnostics.add(Severity::Warning, "sheet.magnified", 1,
                  fmt::format("the drawing is {:.0f} times as large as the sheet: curved surfaces "
                              "are made to {:.2g} mm of paper; cut the detail out of the model, or "
                              "give `tolerance`, for finer ones",
                              coarser * kMostSheets, on_paper));
}

}  // namespace

double chord_tolerance(const Scene& scene, const Camera& camera, const IllustrateOptions& options) {
  if (options.tolerance) return *options.tolerance;
  const Paper& paper = camera.paper();
  const double sheets = camera.scale() * drawn_bounds(scene, options.part_styles).diagonal() /
                        glm::length(Vec2(paper.width, paper.height));
  return std::max(1.0, sheets / kMostSheets) * kSheetTolerance / camera.scale();
}

RealisedParts::Made RealisedParts::made(std::optional<Made> kept,
                                        const std::shared_ptr<const Form>& form,
                                        const RealiseOptions& options, RunContext& context) {
  const bool looks = form->looks_at_view() && options.view != nullptr;
  const auto same = [&](const Made& one) {
    const bool as_fine =
        one.tolerance == options.tolerance ||
        (!looks && one.tolerance < options.tolerance && one.surface->holds_for_coarser());
    return as_fine && one.crease_angle == options.crease_angle &&
           one.curvature == options.curvature && looks == one.view.has_value() &&
           (!looks || *one.view == *options.view) && form->same_as(*one.form);
  };
  if (kept && same(*kept)) return *std::move(kept);
  kept.reset();
  Made one{.form = form,
           .tolerance = options.tolerance,
           .crease_angle = options.crease_angle,
           .curvature = options.curvature};
  if (looks) one.view = *options.view;
  RealiseOptions told = options;
  told.diagnostics = &one.said;
  one.surface = form->realise(told, context);
  return one;
}

Surfaces RealisedParts::realise(const Scene& scene, const Camera& camera,
                                const PartStyles& part_styles, const IllustrateOptions& options,
                                Diagnostics& diagnostics, RunContext& context) {
  RealiseOptions realise;
  realise.tolerance = chord_tolerance(scene, camera, options);
  realise.view = &camera;
  made_.resize(scene.parts.size());
  Surfaces surfaces;
  // A part that cannot be realised is no reason to refuse the others.
  std::size_t drawn = 0;
  std::exception_ptr first;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (!part_styles.drawn(i)) {
      surfaces.push_back(empty_surface());  // what is kept may be drawn next time
      continue;
    }
    realise.crease_angle = part_styles.style(i).feature.crease_angle;
    realise.curvature = std::ranges::any_of(part_styles.strokes(), [&](const auto& strokes) {
      return strokes.parts[i] && follows_field(*strokes.hatch) &&
             field::find(strokes.hatch->field.name).needs_curvature;
    });
    try {
      made_[i] = made(std::exchange(made_[i], {}), scene.parts[i].form, realise, context);
      diagnostics.append(made_[i]->said);
      surfaces.push_back(made_[i]->surface);
      ++drawn;
    } catch (const GeometryError& e) {
      if (!first) first = std::current_exception();
      diagnostics.add(Severity::Error, "part.not_drawn", 1,
                      fmt::format("{}: the part was left out: {}", scene.parts[i].name, e.what()));
      surfaces.push_back(empty_surface());
    }
  }
  if (drawn == 0 && first) std::rethrow_exception(first);
  if (!options.tolerance) {
    tell_magnified(camera, surfaces, realise.tolerance, diagnostics);
  }
  return surfaces;
}

}  // namespace burin::detail
