#include <burin/annotate/legend_box.h>
#include <burin/arrange/arrange.h>
#include <burin/illustrate/legend.h>

#include "mostly_empty.h"
#include "unseen_highlights.h"

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

Annotations with_rows(Annotations over, const std::vector<bool>& wanted) {
  std::size_t i = 0;
  std::erase_if(over.legend, [&](const LegendRow&) { return !wanted[i++]; });
  return over;
}

/// The rows of the legend for which a sheet is laid out: all, or those alone that a drawing shows.
/// A sheet as large as its drawing has no room for more; where all rows have none, some may have;
/// and a drawing that comes out clearly larger is worth making again.
std::vector<bool> rows_to_lay_out(const Scene& scene, const SheetOfViews& sheet,
                                  const Illustration& illustration, const Drawing& drawing) {
  constexpr double kLarger = 1.1;
  const Annotations& over = *illustration.illustrate.annotations;
  const CalloutOptions& style = illustration.style.callout;
  const Paper& paper = sheet.camera().paper();
  std::vector<bool> all(over.legend.size(), true);
  const std::vector<bool> none(over.legend.size(), false);
  const auto larger_with = [&](const std::vector<bool>& rows) {
    return scale_beside_tables(with_rows(over, rows), style, paper) >
           kLarger * scale_beside_tables(over, style, paper);
  };
  const bool by_rows = illustration.sheet.fits || !legend_box(over, style, paper);
  // Which rows are seen takes longer than to see that it makes no difference.
  if (!by_rows && (illustration.view.scale || !larger_with(none))) return all;
  std::vector<bool> seen = seen_rows(scene, illustration, drawing, {});
  if (by_rows || larger_with(seen)) return seen;
  return all;
}

}  // namespace

Drawing illustrate(const Scene& scene, const SheetOfViews& sheet, const Illustration& illustration,
                   RunContext& context, Session* session) {
  Drawing drawing =
      illustrate(scene, sheet, illustration.style, illustration.illustrate, context, session);
  const std::optional<Annotations>& over = illustration.illustrate.annotations;
  if (over && !over->legend.empty()) {
    std::vector<bool> laid(over->legend.size(), true);
    std::vector<bool> wanted = rows_to_lay_out(scene, sheet, illustration, drawing);
    // At another scale a colour may be seen that was not: rows are added until none is missing.
    while (wanted != laid) {
      laid = wanted;
      Illustration seen = illustration;
      seen.illustrate.annotations = with_rows(*over, laid);
      Scene again = scene;
      const SheetOfViews fitted = plan_sheet(again, seen);
      drawing = illustrate(scene, fitted, seen.style, seen.illustrate, context, session);
      wanted = seen_rows(scene, illustration, drawing, laid);
    }
  }
  drawing.title = illustration.title;
  detail::report_mostly_empty(illustration, drawing);
  detail::report_unseen_highlights(scene, illustration, drawing);
  return drawing;
}

Drawing illustrate(Scene scene, Illustration illustration, RunContext& context) {
  arrange_parts(scene, illustration, context);
  const SheetOfViews sheet = plan_sheet(scene, illustration);
  return illustrate(scene, sheet, illustration, context);
}

}  // namespace burin
