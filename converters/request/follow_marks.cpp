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

class Follower {
 public:
  Follower(const DrawRequest& request, DrawPlan& plan) : request_(request), plan_(plan) {}

  void add(const ModelMarks& marks) {
    const KeyedFile in("{}", marks.source);
    for (const ModelMarks::Look& mark : marks.looks) asked_.looks.push_back(look(in, mark));
    add_steps(in, marks.steps);
    asked_.callouts = asked_.callouts || marks.callouts;
    for (const auto& [number, part] : marks.items) add_item(in, marks.source, number, part);
    if (marks.view) {
      const ViewOptions view = view_of(in, "view", *marks.view, "view.from");
      asked_.view = {view.direction, view.up};
    }
    if (marks.up) asked_.up = view_of(in, "up", *marks.up, "view.up").up;
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
  Look look(const KeyedFile& in, const ModelMarks::Look& mark) {
    LookRequest asked;
    asked.look.place = in.place("");
    asked.look.select = {mark.part};
    if (!mark.hatched) asked.look.hatched = false;
    if (mark.transparent) asked.look.transparent = true;
    if (!mark.listed) asked.look.listed = false;
    if (mark.style) asked.style = in.style_named(*mark.style, "/style");
    return look_of(asked, request_, plan_);
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

  void add_item(const KeyedFile& in, const std::string& source, double number,
                const std::string& part) {
    const int wanted = item_number(in, fmt::format("{:.0f}", number), "");
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
