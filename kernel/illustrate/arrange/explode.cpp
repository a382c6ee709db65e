#include <burin/arrange/arrange.h>
#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/explode/explode.h>
#include <burin/explode/seen.h>

#include "arrows.h"
#include "drawn_shape.h"
#include "rows/measured_rows.h"
#include "rows/seen_feature.h"
#include "saved_view.h"
#include "split_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace burin {
namespace {

/// The steps of a file; reports those that move nothing visible.
std::vector<ExplodeStep> steps_of_file(Scene& scene, const Explode& explode,
                                       const std::vector<bool>& drawn) {
  std::vector<ExplodeStep> steps = explode.steps;
  for (ExplodeStep& step : steps) {
    step.parts.clear();
    try {
      for (const std::string& selector : step.move) {
        for (const std::size_t part : select(scene, selector)) step.parts.push_back(part);
      }
    } catch (const UsageError& e) {
      throw UsageError(step.place + e.what());
    }
    std::ranges::sort(step.parts);
    step.parts.erase(std::unique(step.parts.begin(), step.parts.end()), step.parts.end());
    const auto seen = std::ranges::count_if(step.parts, [&](std::size_t p) { return drawn[p]; });
    if (seen == 0 || seen == std::ranges::count(drawn, true)) {
      scene.diagnostics.add(
          Severity::Warning, "explode.nothing", 1,
          fmt::format("{}a step moves {}, which changes nothing", step.place,
                      seen == 0 ? "no part that is drawn" : "all parts that are drawn"));
    }
  }
  return steps;
}

}  // namespace

std::vector<ExplodeStep> explode_steps(Scene& scene, const Explode& explode,
                                       const std::vector<bool>& drawn, const ExplodeModel& model,
                                       RunContext& context) {
  if (!explode.steps.empty()) return steps_of_file(scene, explode, drawn);
  ExplodeOptions options{.along = explode.along, .one_way = explode.one_way, .fit = explode.fit};
  if (!explode.base.empty()) {
    try {
      options.base = select(scene, explode.base).front();
    } catch (const UsageError& e) {
      throw UsageError(explode.place + e.what());
    }
  }
  context.begin_stage(RunStage::Build);
  std::vector<ExplodeStep> steps = model.find(options, scene.diagnostics, context).steps;
  context.end_stage();
  return steps;
}

namespace {

/// Turns the view to where most parts are seen.
void find_view(Scene& scene, Illustration& illustration, const ExplodeModel& model,
               const std::vector<Vec3>& moves, RunContext& context) {
  constexpr double kAlong = 1e-6;  // radians, as Camera has it
  const Vec3 first = glm::normalize(illustration.view.direction),
             up = glm::normalize(illustration.view.up);
  if (std::ranges::any_of(corners_about(first), [&](const Vec3& corner) {
        return glm::length(glm::cross(corner, up)) <= kAlong;
      })) {
    return;  // it is no up there
  }
  const std::vector<PartStyle>& styles = illustration.illustrate.part_styles;
  std::vector<std::size_t> there;  // what can be looked through hides nothing
  for (std::size_t i = 0; i < styles.size(); ++i) {
    if (styles[i].drawn && !styles[i].transparent) there.push_back(i);
  }
  context.begin_stage(RunStage::Build);
  const auto found = clearest_outlook(model.proxies(), there, moves, {first, up}, context);
  context.end_stage();
  if (!found || found->seen == found->seen_first) return;
  const Vec3 size = glm::abs(found->direction);
  const Vec3 d = glm::round(1e6 * found->direction / std::max({size.x, size.y, size.z})) / 1e6;
  illustration.view.direction = d;
  scene.diagnostics.add(
      Severity::Info, "explode.view", 1,
      fmt::format("the view is {:g},{:g},{:g}: {} of {} parts are seen there, {} from iso; `view "
                  "iso` or another one is kept",
                  d.x, d.y, d.z, found->seen, found->of, found->seen_first));
}

}  // namespace

std::vector<ExplodeStep> explode_steps(Scene& scene, const Illustration& illustration,
                                       RunContext& context) {
  if (!illustration.explode.steps.empty()) return illustration.explode.steps;
  const std::vector<bool> drawn = drawn_parts(scene, illustration.illustrate.part_styles);
  const ExplodeModel model(scene, drawn, context);
  std::vector<ExplodeStep> steps =
      explode_steps(scene, illustration.explode, drawn, model, context);
  for (ExplodeStep& step : steps) step.move = selectors_of(scene, step.parts);
  return steps;
}

namespace {

/// By the steps that are given back.
std::vector<ExplodeStep> place_parts(Scene& scene, Illustration& illustration,
                                     RunContext& context) {
  if (!illustration.explode.wanted) {
    cut_parts(scene, illustration);
    detail::look_at_cuts(scene, illustration, context);
    return {};
  }
  const std::vector<bool> drawn = drawn_parts(scene, illustration.illustrate.part_styles);
  const ExplodeModel model(scene, drawn, context);
  std::vector<ExplodeStep> steps =
      explode_steps(scene, illustration.explode, drawn, model, context);
  std::vector<Vec3> moves = moves_of(steps, scene.parts.size(), illustration.explode.factor);
  if (illustration.finds_view) find_view(scene, illustration, model, moves, context);
  illustration.illustrate.trails = model.trails(steps, illustration.explode.factor);
  detail::move_rows(scene, illustration, moves);
  detail::split_glazed(scene, illustration, moves);
  cut_parts(scene,
            illustration);  // where they belong: a section does not go through what has come apart
  detail::look_at_cuts(scene, illustration, context);
  move_parts(scene, moves);
  for (const SectionView& view : illustration.section_views) move_parts(*view.scene, moves);
  return steps;
}

/// Centre lines go beyond the outline, to which a drawing is fitted.
void keep_room_for_centre_lines(Illustration& illustration) {
  double room = 0;
  const auto look_at = [&](const Style& style) {
    if (!style.feature.centre_lines) return;
    room = std::max(room, style.line.centre_over + style.line.centre);
  };
  look_at(illustration.style);
  for (const PartStyle& part : illustration.illustrate.part_styles) {
    if (part.drawn && part.style) look_at(*part.style);
  }
  Margin& margin = illustration.sheet.margin;
  for (double* side : {&margin.top, &margin.right, &margin.bottom, &margin.left}) {
    *side = std::max(*side, room);
  }
}

void add_title_block(Illustration& illustration) {
  if (!illustration.title_block) return;
  std::optional<Annotations>& over = illustration.illustrate.annotations;
  if (!over) over.emplace().margin = illustration.sheet.margin;
  over->title_block = illustration.title_block;
  if (!illustration.title.empty()) {
    over->title_block->fields.try_emplace("title", illustration.title);
  }
}

}  // namespace

void arrange_parts(Scene& scene, Illustration& illustration, RunContext& context) {
  select_parts(scene, illustration);
  detail::take_saved_view(scene, illustration);
  keep_room_for_centre_lines(illustration);
  if (illustration.overall_dimensions)
    illustration.whole = drawn_bounds(scene, illustration.illustrate.part_styles);
  detail::measure_rows(scene, illustration, context);
  number_parts(scene, illustration, context);
  detail::number_notes(illustration);
  find_threads(scene, illustration, context);
  const std::vector<ExplodeStep> steps = place_parts(scene, illustration, context);
  find_breaks(scene, illustration, context);
  detail::add_arrows(scene, illustration, steps);
  detail::look_at_sights(scene, illustration, context);
  add_title_block(illustration);
  std::optional<Annotations>& over = illustration.illustrate.annotations;
  const bool tables = over && (over->parts_list || !over->legend.empty() || over->title_block);
  if (tables) over->shape = detail::drawn_shape(scene, illustration);
}

}  // namespace burin
