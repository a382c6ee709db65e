#include <burin/annotate/legend_box.h>
#include <burin/arrange/arrange.h>
#include <burin/illustrate/legend.h>

#include "mostly_empty.h"

#include <optional>
#include <utility>

namespace burin {
namespace {

/// The sheet with room for those rows of the legend alone that a drawing shows, where that is
/// another: a sheet as large as the drawing has no room for more, and what had no room for all rows
/// may have it for some.
std::optional<Illustration> with_legend_as_seen(const Scene& scene, const SheetOfViews& sheet,
                                                const Illustration& illustration,
                                                const Drawing& drawing) {
  const std::optional<Annotations>& over = illustration.illustrate.annotations;
  if (!over || over->legend.empty()) return std::nullopt;
  const Paper paper = sheet.camera().paper();
  if (!illustration.sheet.fits &&
      legend_box(*over, illustration.style.callout, paper).has_value()) {
    return std::nullopt;
  }
  Annotations seen = with_seen_rows(scene, illustration.style, illustration.illustrate, drawing);
  if (std::erase_if(seen.legend, [](const LegendRow& row) { return !row.seen; }) == 0)
    return std::nullopt;
  Illustration out = illustration;
  out.illustrate.annotations = std::move(seen);
  return out;
}

}  // namespace

Drawing illustrate(const Scene& scene, const SheetOfViews& sheet, const Illustration& illustration,
                   RunContext& context, Session* session) {
  Drawing drawing =
      illustrate(scene, sheet, illustration.style, illustration.illustrate, context, session);
  if (const auto seen = with_legend_as_seen(scene, sheet, illustration, drawing)) {
    Scene again = scene;
    const SheetOfViews fitted = plan_sheet(again, *seen);
    drawing = illustrate(scene, fitted, seen->style, seen->illustrate, context, session);
  }
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
