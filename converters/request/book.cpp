#include <burin/converters/messages.h>
#include <burin/converters/request.h>

#include "make_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// What is asked for that is about one drawing, as `with_spelling` takes it.
std::vector<std::string> about_one_drawing(const DrawPlan& plan) {
  std::vector<std::string> out;
  const bool own_view = std::ranges::any_of(plan.sections, &Section::own_view);
  for (const auto& [asked, name] :
       {std::pair(!plan.views.empty(), "`views`"),
        {own_view, "`section_view`"},
        {plan.overall_dimensions || !plan.dimensions.empty(), "`dimensions`"},
        {!plan.note_rows.empty(), "`note`"},
        {!plan.arrows.empty(), "`arrow`"},
        {plan.step_arrows, "`arrows`"},
        {!plan.breaks.empty(), "`break_view`"},
        {!plan.details.empty(), "`detail`"},
        {plan.legend, "`legend`"},
        {plan.title_block.has_value(), "`title_block`"},
        {!plan.parts_list_files.empty(), "`parts_list` as a file"},
        {plan.view.center.has_value(), "`center`"},
        {plan.explode.factor != 1, "`explode_factor`"}}) {
    if (asked) out.emplace_back(name);
  }
  return out;
}

}  // namespace

Book draw_book(Scene& scene, DrawPlan& plan, const BuildOptions& build, RunContext& context) {
  const std::vector<std::string> unused = about_one_drawing(plan);
  plan.legend = false;
  Book book = make_book(scene, plan, build, context);
  book.diagnostics.append(plan.notes);
  book.diagnostics.append(detail::unused_keys(plan, {.legend = true}));
  if (!unused.empty()) {
    book.diagnostics.add(Severity::Warning, "option.unused",
                         static_cast<std::int64_t>(unused.size()),
                         fmt::format("{} {} no effect on a step book", fmt::join(unused, ", "),
                                     unused.size() > 1 ? "have" : "has"));
  }
  book.diagnostics = with_spelling(book.diagnostics, plan.spelling);
  return book;
}

}  // namespace burin
