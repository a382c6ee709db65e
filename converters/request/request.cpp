#include <burin/base/error.h>
#include <burin/converters/messages.h>
#include <burin/converters/request.h>
#include <burin/field/catalogue.h>
#include <burin/plugin/plugins.h>
#include <burin/tone/catalogue.h>

#include "draw_options.h"
#include "make_plan.h"
#include "named_files.h"
#include "style_files.h"

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

/// Whether the light is seen without any strokes: in flat tones, shadows, or lines of equal light.
bool shows_light(const Style& style) {
  return style.fill.steps > 1 || style.feature.isophotes > 0 || style.shadow.cast ||
         style.shadow.ground;
}

/// What is asked for of strokes alone, as messages call it.
std::vector<std::string> about_strokes(const DrawRequest& r, const Style& named,
                                       const DrawPlan& plan) {
  std::vector<std::string> choices;
  const bool light = shows_light(plan.style);
  if (!light && r.has("light") && plan.style.tone.light != named.tone.light) {
    choices.push_back(called("light", plan.spelling));
  }
  for (const std::string& key : plan.style_keys) {
    const bool of_areas =
        key == "tone.steps" || key == "tone.darkest" || (light && key == "tone.light");
    if (!of_areas && key != "hatch.enabled" &&
        (key.starts_with("hatch.") || key.starts_with("tone.") || key.starts_with("strokes."))) {
      choices.push_back("style key " + key);
    }
  }
  return choices;
}

struct LookStyle {
  Style style;
  /// Its text says so itself.
  bool is_opaque = false;
};

/// The style of a look; nothing where it has none. What it says of files is ignored.
std::optional<LookStyle> style_of(const LookRequest& look, const Style& whole) {
  if (!look.style_text.empty()) {
    Style style = parse_style(look.style_text, look.style_source, whole, &whole);
    detail::find_named_files(style, std::filesystem::path(look.style_source).parent_path());
    return LookStyle{std::move(style), detail::is_said_opaque(look.style_text)};
  }
  if (look.style.empty()) return std::nullopt;
  try {
    const auto text = detail::text_of_style(look.style);
    if (!text) return LookStyle{builtin_style(look.style)};
    return LookStyle{detail::read_style(*text, look.style, &whole), detail::is_said_opaque(*text)};
  } catch (const UsageError& e) {
    throw UsageError(look.look.place + e.what());
  }
}

/// A part that is to be painted opaque is not of glass, whatever its file says of it, and has the
/// strokes of its style.
void leave_glass(Look& look) {
  if (look.transparent) return;
  look.transparent = false;
  look.hatched = look.hatched.value_or(true);
}

/// Lights are those of the scene: whatever style a part has, they shine on it.
void light_by(const DrawRequest& request, Style& style) {
  if (request.lights.empty() || request.has("light")) return;
  for_each_tone(style, [&](tone::ToneOptions& tone) {
    tone.lights = request.lights;
    for (const tone::Light& light : request.lights) {
      if (light.kind != tone::Light::Kind::From) continue;
      tone.light = light.place;  // what directions of strokes look at
      break;
    }
  });
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
  drawing.diagnostics = with_spelling(drawing.diagnostics, plan.spelling);
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
  return detail::plan_of(request, {}, spelling);
}

namespace detail {

Diagnostics unused_choices(const Request& options, const DrawPlan& plan) {
  Diagnostics notes;
  const auto has = [&](const char* name) { return !given_texts(options, name).empty(); };
  const auto note = [&](const std::string& text) {
    notes.add(Severity::Warning, "option.unused", 1, text);
  };
  if (has("light") && !looks_at_light(plan.style) && !shows_light(plan.style)) {
    note(fmt::format("{} has no effect: tone.law {} does not look at it",
                     called("light", plan.spelling), plan.style.tone.law));
  }
  const bool lists = plan.callouts || plan.parts_list || plan.legend;
  for (const std::string& key : plan.style_keys) {
    if (key.starts_with("callout.") && !lists) {
      note(fmt::format("style key {} has no effect without {}", key,
                       called(key == "callout.legend" ? "legend" : "callouts", plan.spelling)));
    }
  }
  if (plan.illustrate.hidden == HiddenLines::Dashed && plan.style.halo.hidden) {
    note(fmt::format("{} has no effect: style '{}' draws hidden lines in full (halo.hidden)",
                     called("hidden", plan.spelling), plan.style.name));
  }
  // view and up say which half of a section goes.
  if (has("center") && !plan.views.empty()) {
    note(fmt::format("{} has no effect beside {}", called("center", plan.spelling),
                     called("views", plan.spelling)));
  }
  if (has("projection") && plan.views.empty()) {
    note(fmt::format("{} has no effect without {}", called("projection", plan.spelling),
                     called("views", plan.spelling)));
  }
  if (has("explode_factor") && !plan.explode.wanted) {
    note(called("explode_factor", plan.spelling) + " has no effect: nothing comes apart");
  }
  if (has("up")) {
    constexpr double kAlong = 1e-6;  // radians, as Camera has it
    const Vec3 up = glm::normalize(plan.view.up), to = glm::normalize(plan.view.direction);
    if (glm::length(glm::cross(up, to)) <= kAlong) {
      note(called("up", plan.spelling) + " has no effect: it lies along the view");
    }
  }
  return notes;
}

Look look_of(const LookRequest& asked, const DrawRequest& request, DrawPlan& plan) {
  Look look = asked.look;
  auto own = style_of(asked, plan.style);
  if (!own) return look;
  look.style = std::move(own->style);
  if (own->is_opaque) leave_glass(look);
  read_images(*look.style, plan.illustrate.images);
  light_by(request, *look.style);
  return look;
}

/// Parts that come apart cast shadows far from where they belong, for which a sheet would have to
/// be larger: only who sets the key, or has a style of his own, has them.
void leave_out_ground(const Style& named, DrawPlan& plan) {
  const bool is_set = std::ranges::find(plan.style_keys, "shadow.ground") != plan.style_keys.end();
  const auto is_named = [&](const StyleInfo& style) { return style.name == named.name; };
  const bool built_in =
      std::ranges::any_of(builtin_styles(), is_named) && named == builtin_style(named.name);
  if (plan.explode.wanted && built_in && !is_set) plan.style.shadow.ground = false;
}

DrawPlan plan_of(const DrawRequest& request, const std::vector<PartStyle>& part_styles,
                 Spelling spelling) {
  Draft draft{.style_text = request.style_text, .style_source = request.style_source};
  DrawPlan& plan = draft.plan;
  plan.title = request.title;
  plan.numbers = request.items;
  plan.sections = request.sections;
  plan.explode = request.explode;
  plan.details = request.details;
  plan.illustrate.part_styles = part_styles;
  plan.spelling = spelling;
  draft.looks = request.looks;
  apply(draw_rows(), request.options, spelling, draft);
  plan.finds_view = !request.has("view") && plan.views.empty();
  leave_out_ground(draft.named, plan);
  check_style(plan.style);
  read_images(plan.style, plan.illustrate.images);
  for (const LookRequest& look : draft.looks) plan.looks.push_back(look_of(look, request, plan));
  light_by(request, plan.style);
  for (PartStyle& part : plan.illustrate.part_styles) {
    if (part.style) light_by(request, *part.style);
  }
  plan.read = make_read_options(request.options, spelling);
  plan.about_strokes = about_strokes(request, draft.named, plan);
  plan.notes = unused_choices(request.options, plan);
  return std::move(draft.plan);
}

}  // namespace detail

}  // namespace burin
