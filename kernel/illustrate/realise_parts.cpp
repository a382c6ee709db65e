#include "realise_parts.h"

#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/field/catalogue.h>
#include <burin/surface/empty_surface.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <thread>
#include <utility>

namespace burin::detail {
namespace {

// Paper mm that a tessellation chosen from the sheet may be off.
constexpr double kSheetTolerance = 0.05;

// Diagonals of the sheet that a drawing may be large before its surfaces are made no finer: what is
// beyond the sheet is made too.
constexpr double kMostSheets = 5;

// A word where a magnified drawing of curved surfaces is coarser than the sheet could show.
void report_magnified(const Camera& camera, const Surfaces& surfaces, double tolerance,
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

void report_left_out(const Part& part, const std::exception_ptr& failed, Diagnostics& diagnostics) {
  try {
    std::rethrow_exception(failed);
  } catch (const GeometryError& e) {
    diagnostics.add(Severity::Error, "part.not_drawn", 1,
                    fmt::format("{}: the part was left out: {}", part.name, e.what()));
  }
}

}  // namespace

double chord_tolerance(const Scene& scene, const Camera& camera, const IllustrateOptions& options) {
  if (options.tolerance) return *options.tolerance;
  const Paper& paper = camera.paper();
  const double sheets = camera.scale() * drawn_bounds(scene, options.part_styles).diagonal() /
                        glm::length(Vec2(paper.width, paper.height));
  return std::max(1.0, sheets / kMostSheets) * kSheetTolerance / camera.scale();
}

RealisedParts::Groups RealisedParts::groups_of(const Scene& scene, const PartStyles& part_styles) {
  Groups groups;
  std::map<const void*, std::size_t> group_of;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (!part_styles.drawn(i)) continue;
    const Form& form = *scene.parts[i].form;
    if (!form.realised_beside_others()) {
      groups.alone.push_back(i);
      continue;
    }
    const auto [group, fresh] =
        group_of.try_emplace(form.definition().shape, groups.together.size());
    if (fresh) groups.together.emplace_back();
    groups.together[group->second].push_back(i);
  }
  // One by itself may as well tell of its stages.
  if (groups.together.size() == 1) {
    groups.alone.insert(groups.alone.end(), groups.together[0].begin(), groups.together[0].end());
    groups.together.clear();
  }
  return groups;
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
  RealiseOptions reporting = options;
  reporting.diagnostics = &one.said;
  one.surface = form->realise(reporting, context);
  return one;
}

// A part that cannot be realised is no reason to refuse the others.
void RealisedParts::make(const Part& part, std::size_t i, Asked& asked, RunContext& context) {
  try {
    made_[i] = made(std::exchange(made_[i], {}), part.form, asked.options, context);
  } catch (const GeometryError&) {
    asked.failed = std::current_exception();
  }
}

void RealisedParts::make_all(const Scene& scene, const PartStyles& part_styles,
                             std::vector<Asked>& asked, RunContext& context) {
  const Groups groups = groups_of(scene, part_styles);
  for (const std::size_t i : groups.alone) make(scene.parts[i], i, asked[i], context);
  if (groups.together.empty()) return;
  context.begin_stage(RunStage::Build);
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<std::size_t> done{0};
  parallel_for(
      groups.together.size(), 1,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t g = begin; g < end; ++g) {
          for (const std::size_t i : groups.together[g]) {
            RunContext piece = RunContext::piece_of(context);
            make(scene.parts[i], i, asked[i], piece);
          }
          const auto all = static_cast<double>(groups.together.size());
          const double share = static_cast<double>(++done) / all;
          if (std::this_thread::get_id() == caller) context.progress(share);
        }
      },
      &context);
  context.end_stage();
}

Surfaces RealisedParts::realise(const Scene& scene, const Camera& camera,
                                const PartStyles& part_styles, const IllustrateOptions& options,
                                Diagnostics& diagnostics, RunContext& context) {
  RealiseOptions realise;
  realise.tolerance = chord_tolerance(scene, camera, options);
  realise.view = &camera;
  made_.resize(scene.parts.size());
  std::vector<Asked> asked(scene.parts.size(), Asked{realise});
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (!part_styles.drawn(i)) continue;
    asked[i].options.crease_angle = part_styles.style(i).feature.crease_angle;
    asked[i].options.curvature =
        std::ranges::any_of(part_styles.strokes(), [&](const auto& strokes) {
          return strokes.parts[i] && follows_field(*strokes.hatch) &&
                 field::find(strokes.hatch->field.name).needs_curvature;
        });
  }
  make_all(scene, part_styles, asked, context);

  Surfaces surfaces;
  std::exception_ptr first;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    // What is kept of parts that are not drawn may be drawn next time.
    const bool is_drawn = part_styles.drawn(i) && !asked[i].failed;
    surfaces.push_back(is_drawn ? made_[i]->surface : empty_surface());
    if (is_drawn) diagnostics.append(made_[i]->said), ++drawn;
    if (!asked[i].failed) continue;
    if (!first) first = asked[i].failed;
    report_left_out(scene.parts[i], asked[i].failed, diagnostics);
  }
  if (drawn == 0 && first) std::rethrow_exception(first);
  if (!options.tolerance) {
    report_magnified(camera, surfaces, realise.tolerance, diagnostics);
  }
  return surfaces;
}

}  // namespace burin::detail
