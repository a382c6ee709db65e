#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/converters/diff.h>
#include <burin/converters/messages.h>
#include <burin/drawing/views.h>

#include "difference_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {
namespace {

/// Paper mm about the legend of a drawing whose margin is its own.
constexpr double kLegendSide = 10, kLegendFoot = 3;
/// Paper mm of a sheet whose size is not known yet.
constexpr double kFitted = 120;

std::string title_of(const std::string& before, const std::string& after) {
  return before + " to " + after;
}

/// The parts that are drawn, and their styles.
void keep_drawn(Scene& scene, std::vector<PartStyle>& styles) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (!styles[i].drawn) continue;
    if (kept != i) {
      scene.parts[kept] = std::move(scene.parts[i]);
      styles[kept] = std::move(styles[i]);
    }
    ++kept;
  }
  scene.parts.resize(kept);
  styles.resize(kept);
}

/// Both scenes in one, those of the old revision first.
Scene together(const Scene& before, const Scene& after) {
  Scene both;
  both.parts = before.parts;
  both.parts.insert(both.parts.end(), after.parts.begin(), after.parts.end());
  return both;
}

template <class T>
std::vector<T> joined(std::vector<T> a, const std::vector<T>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Fills the plans' part styles, and leaves out what the user leaves out.
void choose_parts(Revision& before, Revision& after) {
  std::vector<PartStyle>&was = before.plan.illustrate.part_styles,
  &is = after.plan.illustrate.part_styles;
  if (before.own_looks || after.own_looks) {
    select_parts(before.scene, before.plan);
    select_parts(after.scene, after.plan);
    return;
  }
  split_parts(before.scene, after.plan, was);
  split_parts(after.scene, after.plan, is);
  Scene both = together(before.scene, after.scene);
  DrawPlan plan = after.plan;
  plan.illustrate.part_styles = joined(was, is);
  select_parts(both, plan);
  const auto middle =
      plan.illustrate.part_styles.begin() + static_cast<std::ptrdiff_t>(before.scene.parts.size());
  was.assign(plan.illustrate.part_styles.begin(), middle);
  is.assign(middle, plan.illustrate.part_styles.end());
  keep_drawn(before.scene, was);
  keep_drawn(after.scene, is);
}

/// What of the plan is about one model alone.
void leave_out(DrawPlan& plan) {
  if (plan.overall_dimensions || !plan.dimensions.empty()) {
    plan.overall_dimensions = false;
    plan.dimensions.clear();
    plan.notes.add(Severity::Warning, "option.unused", 1,
                   "dimensions have no effect on a drawing of two revisions");
  }
  if (!plan.arrows.empty() || plan.step_arrows) {
    plan.arrows.clear();
    plan.step_arrows = false;
    plan.notes.add(Severity::Warning, "option.unused", 1,
                   "arrows have no effect on a drawing of two revisions");
  }
  if (!plan.note_rows.empty()) {
    plan.note_rows.clear();
    plan.notes.add(Severity::Warning, "option.unused", 1,
                   "`note` has no effect on a drawing of two revisions");
  }
  if (std::erase_if(plan.sections, [](const Section& section) { return section.own_view; }) > 0) {
    plan.notes.add(Severity::Warning, "option.unused", 1,
                   "section views have no effect on a drawing of two revisions: `section` cuts all "
                   "of its views");
  }
  if (!plan.breaks.empty()) {
    plan.breaks.clear();
    plan.notes.add(Severity::Warning, "option.unused", 1,
                   "`break_view` has no effect on a drawing of two revisions");
  }
  const bool asked = plan.explode.wanted || plan.callouts || plan.parts_list || plan.legend ||
                     plan.title_block || !plan.parts_list_files.empty();
  plan.explode = {};
  plan.callouts = plan.parts_list = plan.legend = plan.items = false;
  plan.parts_list_files.clear();
  plan.title_block.reset();
  plan.illustrate.annotations.reset();
  if (!asked) return;
  plan.notes.add(Severity::Warning, "option.unused", 1,
                 "exploded view, callouts, parts list, legend and title block have no effect on a "
                 "drawing of two "
                 "revisions, whose parts stay in place");
}

/// Room for the legend.
void widen_margin(DrawPlan& plan) {
  Margin& margin = plan.sheet.margin;
  const double width =
      plan.sheet.fits ? kFitted : plan.view.paper.width - margin.left - margin.right;
  margin.bottom += legend_height(plan.style.callout, width);
  // A perspective view knows one margin.
  if (plan.view.perspective) margin = Margin(margin.bottom);
}

Drawing nothing_of(const Drawing& other) {
  Drawing none = other;
  none.layers.clear();
  none.parts.clear();
  none.areas.clear();
  none.diagnostics = {};
  none.stats = {};
  return none;
}

/// What is said of lines alone, as the old revision is drawn, is of no interest.
void forget_unused(Drawing& drawing) {
  Diagnostics kept;
  for (const Diagnostic& d : drawing.diagnostics.entries()) {
    if (d.code != "option.unused" && !d.code.starts_with("stroke")) kept.add(d);
  }
  drawing.diagnostics = std::move(kept);
}

bool draws_anything(const Scene& scene, const std::vector<PartStyle>& styles) {
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    if (i >= styles.size() || styles[i].drawn) return true;
  }
  return false;
}

Drawing draw_both(Revision& before, Revision& after, const Difference& difference,
                  RunContext& context) {
  DrawPlan plan = after.plan;
  leave_out(plan);
  const Margin margin = plan.sheet.margin;
  widen_margin(plan);
  const std::vector<PartStyle> styles =
      joined(before.plan.illustrate.part_styles, after.plan.illustrate.part_styles);
  plan.illustrate.part_styles = styles;
  Scene both = together(before.scene, after.scene);
  cut_parts(both, plan);
  const SheetOfViews sheet = plan_sheet(both, plan);
  const auto middle = static_cast<std::ptrdiff_t>(before.scene.parts.size());
  Scene was, is;
  was.parts.assign(both.parts.begin(), both.parts.begin() + middle);
  is.parts.assign(both.parts.begin() + middle, both.parts.end());
  is.diagnostics = both.diagnostics;

  OverlayOptions options{plan.illustrate.hidden == HiddenLines::Dashed, plan.style.callout, margin};
  DrawPlan lines = plan, full = plan;
  lines.illustrate.hidden = full.illustrate.hidden = HiddenLines::Dashed;
  lines.illustrate.part_styles.assign(styles.begin(), styles.begin() + middle);
  for (PartStyle& style : lines.illustrate.part_styles) style.hatched = false;
  full.illustrate.part_styles.assign(styles.begin() + middle, styles.end());
  full.title = title_of(before.name, after.name);
  std::optional<Drawing> old_one, new_one;
  if (draws_anything(is, full.illustrate.part_styles)) {
    new_one = draw(is, sheet, full, context);
  }
  if (draws_anything(was, lines.illustrate.part_styles) && (!difference.same() || !new_one)) {
    old_one = draw(was, sheet, lines, context);
    forget_unused(*old_one);
  }
  if (!new_one && !old_one) throw UsageError("all parts are left out; nothing is left to draw");
  if (!new_one) new_one = nothing_of(*old_one);
  if (!old_one) old_one = nothing_of(*new_one);
  new_one->title = full.title;
  context.begin_stage(RunStage::Compose);
  Drawing drawing = overlay({*old_one, *new_one}, difference, sheet, options, context);
  context.end_stage();
  return drawing;
}

/// Leaves out the parts that neither drawing shows; how many.
std::size_t forget_undrawn(Difference& difference) {
  const auto undrawn = [&](const PartDifference& part) {
    const bool was = part.match.before != kNoPart && part.drawn_before;
    const bool is = part.match.after != kNoPart && part.drawn_after;
    if (!was && !is) --difference.counts[static_cast<std::size_t>(part.change())];
    return !was && !is;
  };
  return std::erase_if(difference.parts, undrawn);
}

}  // namespace

Revision read_revision(DrawTask& task, std::string name, RunContext& context) {
  const bool callouts = task.plan.callouts;
  Scene scene = task.follow(task.read(context));
  Revision revision{std::move(scene), task.plan, std::move(name), task.has_own_looks()};
  revision.plan.callouts = callouts;
  return revision;
}

DiffOutcome diff_models(Revision before, Revision after, bool draws, RunContext& context) {
  DiffOutcome outcome;
  outcome.before = before.name;
  outcome.after = after.name;
  choose_parts(before, after);
  const auto drawn = [](const Revision& r) {
    return drawn_parts(r.scene, r.plan.illustrate.part_styles);
  };
  append_new(before.scene.diagnostics, outcome.diagnostics);
  append_new(after.scene.diagnostics, outcome.diagnostics);
  outcome.models = compare_revisions(before.scene, after.scene, drawn(before), drawn(after),
                                     outcome.diagnostics, context);
  if (const std::size_t undrawn = forget_undrawn(*outcome.models); undrawn > 0) {
    outcome.diagnostics.add(Severity::Info, "diff.not_drawn", static_cast<std::int64_t>(undrawn),
                            "parts that neither revision draws are left out of the report");
  }
  outcome.same = outcome.models->same();
  outcome.rows = detail::rows_of(*outcome.models);
  const auto shown = [&](const Revision& r) {
    return static_cast<std::size_t>(std::ranges::count(drawn(r), true));
  };
  outcome.counts = detail::counts_of(*outcome.models, shown(before), shown(after));
  outcome.diagnostics = with_spelling(outcome.diagnostics, after.plan.spelling);
  if (draws) outcome.drawing = draw_both(before, after, *outcome.models, context);
  return outcome;
}

DiffOutcome diff_drawings(const Drawing& before, const Drawing& after,
                          const std::string& before_name, const std::string& after_name,
                          double tolerance, bool draws, const RunContext& context) {
  DiffOutcome outcome;
  outcome.before = before_name;
  outcome.after = after_name;
  outcome.lines = compare_drawings(before, after, tolerance, context);
  outcome.same = outcome.lines->same();
  outcome.rows = detail::rows_of(*outcome.lines);
  outcome.counts = detail::counts_of(*outcome.lines);
  if (!draws) return outcome;
  OverlayOptions options;
  options.margin = {kLegendSide, kLegendSide, kLegendFoot, kLegendSide};
  outcome.drawing = overlay({before, after}, *outcome.lines, options, context);
  outcome.drawing->title = title_of(before_name, after_name);
  return outcome;
}

}  // namespace burin
