#include <burin/base/error.h>
#include <burin/converters/messages.h>
#include <burin/converters/request.h>

#include "explode_option.h"

#include <string>
#include <vector>

namespace burin {
namespace {

/// What all that is drawn is called together.
std::string name_of(const Scene& scene, const std::vector<bool>& drawn) {
  std::vector<std::size_t> parts;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    if (drawn[i]) parts.push_back(i);
  }
  return parts.empty() ? std::string() : name_together(scene, drawn, parts);
}

}  // namespace

Book draw_book(Scene& scene, DrawPlan& plan, const BuildOptions& build, RunContext& context) {
  if (plan.sheet.fits) {
    throw UsageError("the pages of a step book have one size: give `paper` one");
  }
  plan.items = true;
  select_parts(scene, plan);
  number_parts(scene, plan, context);
  const std::vector<bool> drawn = drawn_parts(scene, plan.illustrate.part_styles);
  const ExplodeModel model(scene, drawn, context);
  const std::vector<ExplodeStep> steps =
      detail::steps_of(scene, plan.explode, drawn, model, context);
  cut_parts(scene, plan);
  const BookOptions options{plan.view, plan.sheet.margin, build, plan.callouts};
  Book book = make_book(scene, model, steps, options, plan.style, plan.illustrate, context);
  book.title = plan.title.empty() ? name_of(scene, drawn) : plan.title;
  book.diagnostics.append(plan.notes);
  if (!plan.views.empty() || !plan.details.empty()) {
    book.diagnostics.add(Severity::Warning, "option.unused", 1,
                         "several views and details have no effect on a step book");
  }
  book.diagnostics = at_door(book.diagnostics, plan.spelling);
  return book;
}

}  // namespace burin
