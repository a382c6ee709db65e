#include <burin/arrange/arrange.h>

#include "mostly_empty.h"

#include <utility>

namespace burin {

Drawing illustrate(const Scene& scene, const SheetOfViews& sheet, const Illustration& illustration,
                   RunContext& context, Session* session) {
  Drawing drawing =
      illustrate(scene, sheet, illustration.style, illustration.illustrate, context, session);
  drawing.title = illustration.title;
  detail::report_mostly_empty(illustration, drawing);
  return drawing;
}

Drawing illustrate(Scene scene, Illustration illustration, RunContext& context) {
  arrange_parts(scene, illustration, context);
  const SheetOfViews sheet = plan_sheet(scene, illustration);
  return illustrate(scene, sheet, illustration, context);
}

}  // namespace burin
