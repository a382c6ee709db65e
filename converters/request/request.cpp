#include <burin/base/error.h>
#include <burin/converters/messages.h>
#include <burin/converters/request.h>
#include <burin/illustrate/ground.h>
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

/// The style of a look; nothing where it has none. What it says of files is ignored.
std::optional<detail::LoadedStyle> style_of(const LookRequest& look, const Style& whole) {
  if (!look.style_text.empty()) {
    Style style = parse_style(look.style_text, look.style_source, whole, &whole);
    detail::find_named_files(style, std::filesystem::path(look.style_source).parent_path());
    return detail::LoadedStyle{std::move(style), look.style_text, look.style_source};
  }
  if (look.style.empty()) return std::nullopt;
  try {
    return detail::load_with_text(look.style, &whole);
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

/// What is asked for of the whole drawing holds for a part in a style of its own, too.
void follow_whole(const DrawRequest& request, const DrawPlan& plan, Style& style) {
  light_by(request, style);
  if (request.has("centre_lines")) style.feature.centre_lines = plan.style.feature.centre_lines;
}

/// Whether the shadow on the ground is seen in any view.
bool sees_ground(const SheetOfViews& sheet, const Style& style) {
  return std::ranges::any_of(sheet.views, [&](const PlacedView& view) {
    const Vec3 to_viewer = view.camera.direction();
    const bool left_out =
        sheet.method && style.shadow.ground && !style_in_grid(style, to_viewer).shadow.ground;
    return !left_out && casts_ground_shadow(tone::to_light(view.camera, style.tone), to_viewer);
  });
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
  drawing.diagnostics.append(detail::unused_keys(
      plan, {.legend = plan.legend, .ground_seen = sees_ground(sheet, plan.style)}));
  drawing.diagnostics = with_spelling(drawing.diagnostics, plan.spelling);
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
  const bool own_views = std::ranges::any_of(plan.sections, &Section::own_view);
  const bool lists =
      plan.callouts || plan.parts_list || plan.legend || own_views || !plan.details.empty();
  for (const std::string& key : plan.style_keys) {
    if (key.starts_with("dimension.") && !plan.overall_dimensions && plan.dimensions.empty() &&
        plan.note_rows.empty()) {
      note(fmt::format("style key {} has no effect without {} or {}", key,
                       called("dimensions", plan.spelling), called("note", plan.spelling)));
    }
    if (key.starts_with("break.") && plan.breaks.empty()) {
      note(fmt::format("style key {} has no effect without {}", key,
                       called("break_view", plan.spelling)));
    }
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
  if (has("title_block_field") && !has("title_block")) {
    note(fmt::format("{} has no effect without {}", called("title_block_field", plan.spelling),
                     called("title_block", plan.spelling)));
  }
  if (has("hidden_views") && plan.illustrate.hidden == HiddenLines::None) {
    note(fmt::format("{} has no effect without {}", called("hidden_views", plan.spelling),
                     called("hidden", plan.spelling)));
  } else if (has("hidden_views") && plan.views.empty() && !own_views) {
    note(fmt::format("{} has no effect without {}", called("hidden_views", plan.spelling),
                     called("views", plan.spelling)));
  }
  if (has("projection") && plan.views.empty() && !own_views) {
    note(fmt::format("{} has no effect without {}", called("projection", plan.spelling),
                     called("views", plan.spelling)));
  }
  const auto shows = [](const std::optional<Style>& style) {
    return style && style->feature.threads;
  };
  const bool threads =
      plan.style.feature.threads || std::ranges::any_of(plan.looks, shows, &Look::style);
  if (plan.step_arrows && !plan.explode.wanted) {
    note(fmt::format("{} has no effect without {}", called("arrows", plan.spelling),
                     called("explode", plan.spelling)));
  }
  if (has("thread") && !threads) {
    note(fmt::format("{} has no effect: style key feature.threads is false",
                     called("thread", plan.spelling)));
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
  look.style = own->style;
  if (!own->text.empty() && is_said_opaque(own->text)) leave_glass(look);
  read_images(*look.style, plan.illustrate.images);
  follow_whole(request, plan, *look.style);
  if (!own->text.empty() && !asked.is_made) {
    plan.written_keys.push_back(written_in(*own, plan.style, *look.style));
    plan.written_keys.back().of_parts = look.style;
  }
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
  plan.breaks = request.breaks;
  plan.details = request.details;
  plan.thread_rows = request.threads;
  plan.dimensions = request.dimensions;
  plan.note_rows = request.notes;
  plan.arrows = request.arrows;
  plan.illustrate.part_styles = part_styles;
  plan.spelling = spelling;
  draft.looks = request.looks;
  apply(draw_rows(), request.options, spelling, draft);
  if (request.has("view") && !plan.saved_view.empty()) {
    throw UsageError(
        "`saved_view` and `view` both say where the drawing is seen from: leave one out");
  }
  plan.finds_view = !request.has("view") && plan.views.empty() && plan.saved_view.empty();
  leave_out_ground(draft.named.style, plan);
  check_style(plan.style);
  read_images(plan.style, plan.illustrate.images);
  for (const LookRequest& look : draft.looks) plan.looks.push_back(look_of(look, request, plan));
  light_by(request, plan.style);
  for (PartStyle& part : plan.illustrate.part_styles) {
    if (part.style) follow_whole(request, plan, *part.style);
  }
  plan.read = make_read_options(request.options, spelling);
  plan.read.pmi |= !plan.saved_view.empty();
  plan.asked_keys = asked_keys(request, draft.named.style, plan);
  if (!draft.named.text.empty()) {
    plan.written_keys.push_back(written_in(draft.named, builtin_style("technical"), plan.style));
  }
  plan.notes = unused_choices(request.options, plan);
  return std::move(draft.plan);
}

}  // namespace detail

}  // namespace burin
