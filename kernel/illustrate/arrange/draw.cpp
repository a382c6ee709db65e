#include <burin/annotate/legend_box.h>
#include <burin/arrange/arrange.h>
#include <burin/illustrate/legend.h>

#include "mostly_empty.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// The rows that are seen in a drawing, or were so before.
std::vector<bool> seen_rows(const Scene& scene, const Illustration& illustration,
                            const Drawing& drawing, std::vector<bool> before) {
  const Annotations told =
      with_seen_rows(scene, illustration.style, illustration.illustrate, drawing);
  before.resize(told.legend.size(), false);
  for (std::size_t i = 0; i < before.size(); ++i) before[i] = before[i] || told.legend[i].seen;
  return before;
}

Illustration with_rows(Illustration illustration, const std::vector<bool>& wanted) {
  std::size_t i = 0;
  std::erase_if(illustration.illustrate.annotations->legend,
                [&](const LegendRow&) { return !wanted[i++]; });
  return illustration;
}

/// Whether a sheet is another with room for those rows of the legend alone that a drawing shows:
/// one as large as the drawing has no room for more, what had no room for all rows may have it for
/// some, and a drawing is worth making again where it comes out clearly larger.
bool is_laid_out_by_rows(const SheetOfViews& sheet, const Illustration& illustration,
                         const std::vector<bool>& wanted) {
  constexpr double kLarger = 1.1;
  const Annotations& over = *illustration.illustrate.annotations;
  const CalloutOptions& style = illustration.style.callout;
  const Paper& paper = sheet.camera().paper();
  if (illustration.sheet.fits || !legend_box(over, style, paper)) return true;
  if (illustration.view.scale || std::ranges::find(wanted, false) == wanted.end()) return false;
  const Illustration seen = with_rows(illustration, wanted);
  return scale_beside_tables(*seen.illustrate.annotations, style, paper) >
         kLarger * scale_beside_tables(over, style, paper);
}

}  // namespace

Drawing illustrate(const Scene& scene, const SheetOfViews& sheet, const Illustration& illustration,
                   RunContext& context, Session* session) {
  Drawing drawing =
      illustrate(scene, sheet, illustration.style, illustration.illustrate, context, session);
  const std::optional<Annotations>& over = illustration.illustrate.annotations;
  if (over && !over->legend.empty()) {
    std::vector<bool> laid(over->legend.size(), true);
    std::vector<bool> wanted = seen_rows(scene, illustration, drawing, {});
    if (!is_laid_out_by_rows(sheet, illustration, wanted)) wanted = laid;
    // At another scale a colour may be seen that was not: rows are added until none is missing.
    while (wanted != laid) {
      laid = wanted;
      const Illustration seen = with_rows(illustration, laid);
      Scene again = scene;
      const SheetOfViews fitted = plan_sheet(again, seen);
      drawing = illustrate(scene, fitted, seen.style, seen.illustrate, context, session);
      wanted = seen_rows(scene, illustration, drawing, laid);
    }
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
