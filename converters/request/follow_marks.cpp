#include "illustration/keyed.h"
#include "make_plan.h"
#include "note_option.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace burin {
namespace {

using detail::KeyedFile;

/// The number that a mark asks for. Throws UsageError that names model and mark.
int item_number_of(const std::string& source, double number) {
  const std::string digits = fmt::format("{:.0f}", number);
  return detail::item_number(KeyedFile::of_mark(source, fmt::format("callout({})", digits)), digits,
                             "");
}

/// As an illustration file has them.
void add_marked_looks(const ModelMarks& marks, std::vector<LookRequest>& looks) {
  for (const ModelMarks::Look& mark : marks.looks) {
    LookRequest& asked = looks.emplace_back();
    asked.look.select = {mark.part};
    asked.look.place = marks.source + ": ";
    if (!mark.hatched) asked.look.hatched = false;
    if (mark.transparent) asked.look.transparent = true;
    if (!mark.listed) asked.look.listed = false;
    if (mark.style) {
      const KeyedFile in =
          KeyedFile::of_mark(marks.source, fmt::format("ink(\"{}\")", *mark.style));
      asked.style = in.style_named(*mark.style, "/style");
    }
  }
}

/// As an illustration file has them. Throws UsageError that names the model.
std::vector<ThreadRow> threads_of(const ModelMarks& marks) {
  std::vector<ThreadRow> out;
  for (const ModelMarks::Thread& mark : marks.threads) {
    ThreadRow row{.select = {mark.part},
                  .size = mark.size,
                  .length = mark.length,
                  .place = marks.source + ": "};
    check_thread_row(row);
    out.push_back(std::move(row));
  }
  return out;
}

/// As an illustration file has them. Throws UsageError that names the model.
std::vector<DimensionRow> notes_of(const ModelMarks& marks) {
  std::vector<DimensionRow> out;
  for (const ModelMarks::Note& mark : marks.notes) {
    DimensionRow row = detail::note_of(fmt::format("{}: note()", marks.source), mark.text);
    row.of = {{.kind = FeatureRow::Kind::Part, .part = mark.part}};
    row.place = marks.source + ": ";
    out.push_back(std::move(row));
  }
  return out;
}

/// Throws UsageError that names the model where the view cannot be what the mark says.
void check_view(const ModelMarks& marks) {
  const KeyedFile in = KeyedFile::of_mark(marks.source, "view()");
  if (marks.view) in.check(detail::draw_rows(), "view", {*marks.view}, "", "from");
  if (marks.up) in.check(detail::draw_rows(), "up", {*marks.up}, "", "up");
}

/// The steps of all models; errors about them name the last one that has some.
void add_steps(const ModelMarks& marks, Explode& explode) {
  if (marks.steps.empty()) return;
  const KeyedFile in = KeyedFile::of_mark(marks.source, "explode()");
  explode.place = in.place("");
  for (const auto& [parts, move] : marks.steps) {
    explode.steps.push_back(
        {.move = parts,
         .along = detail::way_of(in, {move.x, move.y, move.z}, "/along"),
         .by = detail::distance_of(in, std::hypot(move.x, move.y, move.z), "/by"),
         .place = in.place("")});
  }
}

/// Models that ask for numbers which another one has.
Diagnostics taken_numbers(const std::vector<ModelMarks>& all) {
  struct Owner {
    std::string source, part;
  };
  std::map<int, Owner> owners;
  Diagnostics notes;
  for (const ModelMarks& marks : all) {
    for (const auto& [number, part] : marks.items) {
      const int wanted = item_number_of(marks.source, number);
      const Owner& owner = owners.try_emplace(wanted, Owner{marks.source, part}).first->second;
      if (owner.source == marks.source) continue;
      notes.add(Severity::Warning, "marks.number_taken", 1,
                fmt::format("{}: '{}' gets another number than {}, which '{}' has", marks.source,
                            part, wanted, owner.part));
    }
  }
  return notes;
}

/// The view as an option makes it.
ViewOptions view_of(const std::string& option, const Request& options) {
  const auto row = std::ranges::find(detail::draw_rows(), option, &RequestRow<detail::Draft>::name);
  detail::Draft draft;
  apply<detail::Draft>({*row}, {{option, options.at(option)}}, Spelling::Keywords, draft);
  return draft.plan.view;
}

/// `all`: what is asked and, below it, what marks ask. A view that is asked for has its own way up.
void set_view(const DrawRequest& asked, const DrawRequest& all, DrawPlan& plan) {
  if (asked.has("view")) return;
  const bool turned = asked.has("up");
  if (all.has("view")) {
    const ViewOptions view = view_of("view", all.options);
    plan.view.direction = view.direction;
    if (!turned) plan.view.up = view.up;
    plan.finds_view = false;
  }
  if (all.has("up") && !turned) plan.view.up = view_of("up", all.options).up;
}

}  // namespace

DrawRequest with_marks(const std::vector<ModelMarks>& marks, DrawRequest request) {
  std::vector<LookRequest> looks;
  std::vector<ThreadRow> threads;
  std::vector<DimensionRow> notes;
  std::vector<ArrowRow> arrows;
  const bool numbered = !request.items.empty(), seen = request.has("view");
  const bool turned = request.has("up"), chosen = request.has("callouts");
  for (const ModelMarks& one : marks) {
    add_marked_looks(one, looks);
    std::ranges::move(threads_of(one), std::back_inserter(threads));
    std::ranges::move(notes_of(one), std::back_inserter(notes));
    for (const ModelMarks::Arrow& mark : one.arrows) {
      arrows.push_back({.select = {mark.part}, .along = mark.along});
      arrows.back().place = one.source + ": ";
    }
    check_view(one);
    // Of what only one model may ask, the last one counts.
    if (one.callouts && !chosen) request.options["callouts"] = {"true"};
    if (one.view && !seen) request.options["view"] = {*one.view};
    if (one.up && !turned && !seen) request.options["up"] = {*one.up};
    for (const auto& [number, part] : one.items) {
      if (numbered) break;
      request.items.try_emplace(item_number_of(one.source, number),
                                KeptItem{.name = "", .select = part});
    }
  }
  request.looks.insert(request.looks.begin(), looks.begin(), looks.end());
  request.threads.insert(request.threads.begin(), threads.begin(), threads.end());
  request.notes.insert(request.notes.begin(), notes.begin(), notes.end());
  request.arrows.insert(request.arrows.begin(), arrows.begin(), arrows.end());
  return request;
}

void detail::follow_marks(const std::vector<ModelMarks>& marks, const DrawRequest& request,
                          DrawPlan& plan) {
  const DrawRequest all = with_marks(marks, request);
  std::vector<Look> looks;
  for (std::size_t i = 0; i + request.looks.size() < all.looks.size(); ++i) {
    looks.push_back(look_of(all.looks[i], request, plan));
  }
  plan.looks.insert(plan.looks.begin(), std::make_move_iterator(looks.begin()),
                    std::make_move_iterator(looks.end()));
  const auto marked = all.threads.size() - request.threads.size();
  plan.thread_rows.insert(plan.thread_rows.begin(), all.threads.begin(),
                          all.threads.begin() + static_cast<std::ptrdiff_t>(marked));
  const auto noted = all.notes.size() - request.notes.size();
  plan.note_rows.insert(plan.note_rows.begin(), all.notes.begin(),
                        all.notes.begin() + static_cast<std::ptrdiff_t>(noted));
  const auto arrowed = all.arrows.size() - request.arrows.size();
  plan.arrows.insert(plan.arrows.begin(), all.arrows.begin(),
                     all.arrows.begin() + static_cast<std::ptrdiff_t>(arrowed));
  // The way that parts come apart is the model's; whether they do is not.
  Explode explode;
  for (const ModelMarks& one : marks) add_steps(one, explode);
  if (!explode.steps.empty() &&
      given_texts(request.options, "explode") == std::vector<std::string>{"auto"}) {
    plan.explode.steps = std::move(explode.steps);
    plan.explode.place = explode.place;
  }
  if (all.has("callouts") && !request.has("callouts")) plan.callouts = true;
  if (request.items.empty() && !all.items.empty()) plan.numbers = all.items;
  set_view(request, all, plan);
  plan.notes = unused_choices(all.options, plan);
  plan.notes.append(taken_numbers(marks));
}

}  // namespace burin
