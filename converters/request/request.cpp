#include <burin/base/error.h>
#include <burin/converters/messages.h>
#include <burin/converters/request.h>
#include <burin/field/catalogue.h>
#include <burin/plugin/plugins.h>
#include <burin/tone/catalogue.h>

#include "draw_options.h"
#include "named_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

namespace burin {
namespace {

/// Whether the law or the field of any strokes does.
bool looks_at_light(const Style& style) {
  for (std::size_t number = 1; number <= stroke_kind_count(style); ++number) {
    if (tone::find(tone_of(style, number).law).uses_light ||
        field::find(hatch_of(style, number).field.name).uses_light) {
      return true;
    }
  }
  return false;
}

/// What the plan asks for that some drawings or styles have no use for.
void note_unused(const DrawRequest& r, Spelling spelling, const Style& named, DrawPlan& plan) {
  if (r.has("light") && plan.style.tone.light != named.tone.light) {
    plan.about_strokes.push_back(called("light", spelling));
  }
  for (const std::string& assignment : given_texts(r.options, "set")) {
    const std::string key = parted_assignment(assignment).first;
    if (key != "hatch.enabled" &&
        (key.starts_with("hatch.") || key.starts_with("tone.") || key.starts_with("strokes."))) {
      plan.about_strokes.push_back("style key " + key);
    }
  }
  const auto note = [&](const std::string& text) {
    plan.notes.add(Severity::Warning, "option.unused", 1, text);
  };
  if (r.has("light") && !looks_at_light(plan.style)) {
    note(fmt::format("{} has no effect: tone.law {} does not look at it", called("light", spelling),
                     plan.style.tone.law));
  }
  const bool lists = plan.callouts || plan.parts_list;
  for (const std::string& assignment : given_texts(r.options, "set")) {
    const std::string key = parted_assignment(assignment).first;
    if (key.starts_with("callout.") && !lists) {
      note(fmt::format("style key {} has no effect without {}", key, called("callouts", spelling)));
    }
  }
  if (plan.illustrate.hidden == HiddenLines::Dashed && plan.style.halo.hidden) {
    note(fmt::format("{} has no effect: style '{}' draws hidden lines in full (halo.hidden)",
                     called("hidden", spelling), plan.style.name));
  }
  // view and up say which half of a section goes.
  if (r.has("center") && !plan.views.empty()) {
    note(fmt::format("{} has no effect beside {}", called("center", spelling),
                     called("views", spelling)));
  }
  if (r.has("projection") && plan.views.empty()) {
    note(fmt::format("{} has no effect without {}", called("projection", spelling),
                     called("views", spelling)));
  }
  if (r.has("explode_factor") && !plan.explode.wanted) {
    note(called("explode_factor", spelling) + " has no effect: nothing comes apart");
  }
  if (r.has("up")) {
    constexpr double kAlong = 1e-6;  // radians, as Camera has it
    const Vec3 up = glm::normalize(plan.view.up), to = glm::normalize(plan.view.direction);
    if (glm::length(glm::cross(up, to)) <= kAlong) {
      note(called("up", spelling) + " has no effect: it lies along the view");
    }
  }
}

/// The style of a look; nothing where it has none. What it says of files is ignored.
std::optional<Style> style_of(const LookRequest& look, const detail::Draft& draft) {
  if (!look.style_text.empty()) {
    Style style =
        parse_style(look.style_text, look.style_source, draft.plan.style, &draft.plan.style);
    detail::find_named_files(style, std::filesystem::path(look.style_source).parent_path());
    return style;
  }
  if (look.style.empty()) return std::nullopt;
  try {
    return load_style(look.style, &draft.plan.style);
  } catch (const UsageError& e) {
    throw UsageError(look.look.place + e.what());
  }
}

/// Lights are those of the scene: whatever style a part has, they shine on it.
void light_by(const std::vector<tone::Light>& lights, DrawPlan& plan) {
  const auto set = [&](tone::ToneOptions& tone) {
    tone.lights = lights;
    for (const tone::Light& light : lights) {
      if (light.kind != tone::Light::Kind::From) continue;
      tone.light = light.place;  // what directions of strokes look at
      break;
    }
  };
  for_each_tone(plan.style, set);
  for (Look& look : plan.looks) {
    if (look.style) for_each_tone(*look.style, set);
  }
}

bool any_strokes(const DrawPlan& plan) {
  return has_strokes(plan.style) ||
         std::any_of(plan.illustrate.part_styles.begin(), plan.illustrate.part_styles.end(),
                     [](const PartStyle& look) { return look.style && has_strokes(*look.style); });
}

}  // namespace

Drawing draw(const Scene& scene, const SheetOfViews& sheet, const DrawPlan& plan,
             RunContext& context, Session* session) {
  Drawing drawing = illustrate(scene, sheet, plan, context, session);
  drawing.diagnostics.append(plan.notes);
  for (const plugin::Plugin& p : plugin::plugins()) {
    if (p.refused.empty()) continue;
    drawing.diagnostics.add(
        Severity::Warning, "plugin.refused", 1,
        fmt::format("the plug-in {} is left out: {} (burin plugins)", p.file, p.refused));
  }
  drawing.diagnostics = at_door(drawing.diagnostics, plan.spelling);
  if (any_strokes(plan)) return drawing;
  for (const std::string& choice : plan.about_strokes) {
    drawing.diagnostics.add(Severity::Warning, "option.unused", 1,
                            fmt::format("{} has no effect: style '{}' draws no strokes "
                                        "(hatch.enabled=true does)",
                                        choice, plan.style.name));
  }
  return drawing;
}

DrawPlan make_plan(const DrawRequest& request, Spelling spelling) {
  detail::Draft draft{.style_text = request.style_text, .style_source = request.style_source};
  draft.plan.title = request.title;
  draft.plan.numbers = request.items;
  draft.looks = request.looks;
  draft.plan.sections.assign(request.sections.begin(), request.sections.end());
  draft.plan.explode = request.explode;
  draft.plan.details.assign(request.details.begin(), request.details.end());
  apply(detail::draw_rows(), request.options, spelling, draft);
  draft.plan.spelling = spelling;
  draft.plan.finds_view = !request.has("view") && draft.plan.views.empty();
  check_style(draft.plan.style);
  for (const LookRequest& look : draft.looks) {
    draft.plan.looks.push_back(look.look);
    draft.plan.looks.back().style = style_of(look, draft);
  }
  detail::read_images(draft.plan.style, draft.plan.illustrate.images);
  for (const Look& look : draft.plan.looks) {
    if (look.style) detail::read_images(*look.style, draft.plan.illustrate.images);
  }
  if (!request.lights.empty() && !request.has("light")) light_by(request.lights, draft.plan);
  draft.plan.read = make_read_options(request.options, spelling);
  note_unused(request, spelling, draft.named, draft.plan);
  return std::move(draft.plan);
}

}  // namespace burin
