#include "illustration/keyed.h"
#include "make_plan.h"

#include <cmath>
#include <iterator>
#include <map>
#include <optional>

namespace burin::detail {
namespace {

/// What the marks of all models ask together; of what only one may give the last one holds.
struct Asked {
  std::vector<Look> looks;
  std::vector<ExplodeStep> steps;
  std::string steps_place;
  ItemNumbers items;
  bool callouts = false;
  std::optional<NamedView> view;
  std::optional<Vec3> up;
};

/// The number that a mark asks for. Throws UsageError that names model and mark.
int item_number_of(const std::string& source, double number) {
  const std::string digits = fmt::format("{:.0f}", number);
  return item_number(KeyedFile::of_mark(source, fmt::format("callout({})", digits)), digits, "");
}

/// As an illustration file has them.
void add_looks(const ModelMarks& marks, std::vector<LookRequest>& looks) {
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

class Follower {
 public:
  Follower(const DrawRequest& request, DrawPlan& plan) : request_(request), plan_(plan) {}

  void add(const ModelMarks& marks) {
    std::vector<LookRequest> looks;
    add_looks(marks, looks);
    for (const LookRequest& asked : looks) asked_.looks.push_back(look_of(asked, request_, plan_));
    add_steps(KeyedFile::of_mark(marks.source, "explode()"), marks.steps);
    asked_.callouts = asked_.callouts || marks.callouts;
    for (const auto& [number, part] : marks.items) add_item(marks.source, number, part);
    if (marks.view) {
      const ViewOptions view = view_of(of_view(marks), "view", *marks.view, "from");
      asked_.view = {view.direction, view.up};
    }
    if (marks.up) asked_.up = view_of(of_view(marks), "up", *marks.up, "up").up;
  }

  void finish() {
    plan_.looks.insert(plan_.looks.begin(), std::make_move_iterator(asked_.looks.begin()),
                       std::make_move_iterator(asked_.looks.end()));
    // The way that parts come apart is the model's; whether they do is not.
    if (!asked_.steps.empty() &&
        given_texts(request_.options, "explode") == std::vector<std::string>{"auto"}) {
      plan_.explode.steps = std::move(asked_.steps);
      plan_.explode.place = asked_.steps_place;
    }
    if (asked_.callouts && !request_.has("callouts")) plan_.callouts = true;
    if (request_.items.empty() && !asked_.items.empty()) plan_.numbers = std::move(asked_.items);
    set_view();
    Request given = request_.options;
    if (asked_.up && !request_.has("view"))
      given.try_emplace("up", std::vector<std::string>{"marks"});
    plan_.notes = unused_choices(given, plan_);
    plan_.notes.append(clashes_);
  }

 private:
  static KeyedFile of_view(const ModelMarks& marks) {
    return KeyedFile::of_mark(marks.source, "view()");
  }

  void add_steps(const KeyedFile& in, const std::vector<ModelMarks::Step>& steps) {
    if (!steps.empty()) asked_.steps_place = in.place("");
    for (const auto& [parts, move] : steps) {
      asked_.steps.push_back({.move = parts,
                              .along = way_of(in, {move.x, move.y, move.z}, "/along"),
                              .by = distance_of(in, std::hypot(move.x, move.y, move.z), "/by"),
                              .place = in.place("")});
    }
  }

  void add_item(const std::string& source, double number, const std::string& part) {
    const int wanted = item_number_of(source, number);
    const auto [it, is_new] =
        asked_.items.try_emplace(wanted, KeptItem{.name = "", .select = part});
    if (is_new) numbered_by_[wanted] = source;
    if (numbered_by_[wanted] == source) return;
    clashes_.add(Severity::Warning, "marks.number_taken", 1,
                 fmt::format("{}: '{}' gets another number than {}, which '{}' has", source, part,
                             wanted, it->second.select));
  }

  /// The view as an option makes it. `key`: what errors call it.
  static ViewOptions view_of(const KeyedFile& in, const std::string& option,
                             const std::string& text, const std::string& key) {
    in.check(draw_rows(), option, {text}, "", key);
    const auto row = std::ranges::find(draw_rows(), option, &RequestRow<Draft>::name);
    Draft draft;
    apply<Draft>({*row}, {{option, {text}}}, Spelling::Keywords, draft);
    return draft.plan.view;
  }

  void set_view() {
    const bool up_asked = request_.has("up");
    if (asked_.view && !request_.has("view")) {
      plan_.view.direction = asked_.view->direction;
      if (!up_asked) plan_.view.up = asked_.view->up;
      plan_.finds_view = false;
    }
    // A view that is asked for has its own way up.
    if (asked_.up && !up_asked && !request_.has("view")) plan_.view.up = *asked_.up;
  }

  const DrawRequest& request_;
  DrawPlan& plan_;
  Asked asked_;
  /// The model whose mark gave the number.
  std::map<int, std::string> numbered_by_;
  Diagnostics clashes_;
};

}  // namespace

void follow_marks(const std::vector<ModelMarks>& marks, const DrawRequest& request,
                  DrawPlan& plan) {
  Follower follower(request, plan);
  for (const ModelMarks& one : marks) follower.add(one);
  follower.finish();
}

}  // namespace burin::detail

namespace burin {

DrawRequest with_marks(const std::vector<ModelMarks>& marks, DrawRequest request) {
  std::vector<LookRequest> looks;
  const bool numbered = !request.items.empty(), seen = request.has("view");
  const bool turned = request.has("up"), chosen = request.has("callouts");
  for (const ModelMarks& one : marks) {
    detail::add_looks(one, looks);
    if (one.callouts && !chosen) request.options["callouts"] = {"true"};
    if (one.view && !seen) request.options["view"] = {*one.view};
    if (one.up && !turned && !seen) request.options["up"] = {*one.up};
    for (const auto& [number, part] : one.items) {
      if (numbered) break;
      request.items.try_emplace(detail::item_number_of(one.source, number),
                                KeptItem{.name = "", .select = part});
    }
  }
  request.looks.insert(request.looks.begin(), looks.begin(), looks.end());
  return request;
}

}  // namespace burin
