#include <burin/converters/messages.h>
#include <burin/converters/request.h>

namespace burin {

Book draw_book(Scene& scene, DrawPlan& plan, const BuildOptions& build, RunContext& context) {
  Book book = make_book(scene, plan, build, context);
  book.diagnostics.append(plan.notes);
  if (!plan.views.empty() || !plan.details.empty()) {
    book.diagnostics.add(Severity::Warning, "option.unused", 1,
                         "several views and details have no effect on a step book");
  }
  book.diagnostics = with_spelling(book.diagnostics, plan.spelling);
  return book;
}

}  // namespace burin
