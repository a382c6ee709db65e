#include <burin/base/error.h>
#include <burin/converters/messages.h>
#include <burin/converters/request.h>
#include <burin/field/catalogue.h>
#include <burin/tone/catalogue.h>

#include "draw_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// What the plan asks for that some drawings or styles have no use for.
void note_unused(const DrawRequest& r, Spelling spelling, const Style& named, DrawPlan& plan) {
  if (r.has("light") && plan.style.tone.light != named.tone.light) {
    plan.about_strokes.push_back(called("light", spelling));
  }
  for (const std::string& assignment : given_texts(r.options, "set")) {
    const std::string key = parted_assignment(assignment).first;
    if (key != "hatch.enabled" && (key.starts_with("hatch.") || key.starts_with("tone."))) {
      plan.about_strokes.push_back("style key " + key);
    }
  }
  const auto note = [&](const std::string& text) {
    plan.notes.add(Severity::Warning, "option.unused", 1, text);
  };
  const std::string& law = plan.style.tone.law;
  if (r.has("light") && !tone::find(law).uses_light &&
      !field::find(plan.style.hatch.field.name).uses_light) {
    note(fmt::format("{} has no effect: tone.law {} does not look at it", called("light", spelling),
                     law));
  }
  if (plan.illustrate.hidden == HiddenLines::Dashed && plan.style.halo.hidden) {
    note(fmt::format("{} has no effect: style '{}' draws hidden lines in full (halo.hidden)",
                     called("hidden", spelling), plan.style.name));
  }
  if (r.has("up")) {
    constexpr double kAlong = 1e-6;  // radians, as Camera has it
    const Vec3 up = glm::normalize(plan.view.up), to = glm::normalize(plan.view.direction);
    if (glm::length(glm::cross(up, to)) <= kAlong) {
      note(called("up", spelling) + " has no effect: it lies along the view");
    }
  }
}

bool has_strokes(const DrawPlan& plan) {
  return plan.style.hatch.enabled ||
         std::any_of(plan.illustrate.part_styles.begin(), plan.illustrate.part_styles.end(),
                     [](const PartStyle& look) { return look.style && look.style->hatch.enabled; });
}

}  // namespace

Drawing draw(const Scene& scene, const Camera& camera, const DrawPlan& plan, RunContext& context) {
  Drawing drawing = illustrate(scene, camera, plan.style, plan.illustrate, context);
  drawing.diagnostics.append(plan.notes);
  drawing.diagnostics = at_door(drawing.diagnostics, plan.spelling);
  if (has_strokes(plan)) return drawing;
  for (const std::string& choice : plan.about_strokes) {
    drawing.diagnostics.add(Severity::Warning, "option.unused", 1,
                            fmt::format("{} has no effect: style '{}' draws no strokes "
                                        "(hatch.enabled=true does)",
                                        choice, plan.style.name));
  }
  return drawing;
}

Camera make_camera(const Scene& scene, const DrawPlan& plan) {
  const auto extent = [&](const Mat3& axes) { return scene.bounds(axes); };
  return Camera::fit(extent, settle(extent, plan.view, plan.sheet));
}

DrawPlan make_plan(const DrawRequest& request, Spelling spelling) {
  detail::Draft draft{.style_text = request.style_text};
  apply(detail::draw_rows(), request.options, spelling, draft);
  draft.plan.spelling = spelling;
  check_style(draft.plan.style);
  draft.plan.read = make_read_options(request.options, spelling);
  note_unused(request, spelling, draft.named, draft.plan);
  return std::move(draft.plan);
}

}  // namespace burin
