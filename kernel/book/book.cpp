#include <burin/annotate/list_pages.h>
#include <burin/book/book.h>
#include <burin/camera/view_grid.h>
#include <burin/drawing/views.h>

#include "page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// What is said of numbers says of which step.
Diagnostics of_page(const Diagnostics& said, std::size_t number) {
  Diagnostics out;
  for (Diagnostic d : said.entries()) {
    if (d.code.starts_with("callouts.")) d.message = fmt::format("step {}: {}", number, d.message);
    out.add(std::move(d));
  }
  return out;
}

/// Pages that have no room for the scale that was asked for.
void warn_of_smaller(const std::vector<detail::PageScale>& scales, double asked,
                     Diagnostics& diagnostics) {
  double least = asked;
  std::int64_t count = 0;
  for (const detail::PageScale& scale : scales) {
    least = std::min(least, scale.value);
    count += scale.value < asked;
  }
  if (count == 0) return;
  diagnostics.add(
      Severity::Warning, "book.scale", count,
      fmt::format("{} of {} steps are drawn smaller than {}, for which their pages have "
                  "no room: at {} and more; use a larger `paper`",
                  count, scales.size(), scale_text(asked), scale_text(least)));
}

}  // namespace

Book make_book(const Scene& scene, const ExplodeModel& model, const std::vector<ExplodeStep>& steps,
               const BookOptions& book, const Style& style, const IllustrateOptions& options,
               RunContext& context) {
  Book out;
  if (options.annotations) out.items = options.annotations->items;
  const std::vector<bool> drawn = drawn_parts(scene, options.part_styles);
  detail::PageMaker maker{scene, model, book, style, options, drawn, {}, context};
  maker.item_of.resize(scene.parts.size());
  std::vector<int> item_of;
  for (std::size_t i = 0; i < scene.parts.size(); ++i) {
    item_of.push_back(-1 - static_cast<int>(i));
  }
  for (const DrawingItem& item : out.items) {
    for (const std::int32_t part : item.parts) {
      item_of[static_cast<std::size_t>(part)] = item.number;
      maker.item_of[static_cast<std::size_t>(part)] = &item;
    }
  }
  const std::vector<BuildStep> build = build_steps(scene, drawn, steps, item_of, book.build);
  std::vector<detail::PagePlan> plans;
  std::vector<detail::FittedPage> fitted;
  for (const BuildStep& step : build) {
    context.check();
    plans.push_back(maker.plan(step, plans.size() + 1));
    fitted.push_back({step.assembly, plans.back().fitted});
  }
  std::vector<detail::PageScale> scales =
      detail::common_scales(fitted, {.iso = book.iso_scale, .given = book.view.scale});
  if (book.view.scale) warn_of_smaller(scales, *book.view.scale, out.diagnostics);
  for (std::size_t i = 0; i < build.size(); ++i) {
    context.check();
    // In perspective no one scale holds on a page.
    if (book.view.perspective) scales[i].told.clear();
    out.pages.push_back(maker.draw(build[i], i + 1, plans[i], scales[i]));
    append_new(of_page(out.pages.back().drawing.diagnostics, out.pages.size()), out.diagnostics);
  }
  CalloutOptions large = style.callout;
  large.list_height *= 1.4;  // a sheet of its own has room
  out.lists = list_pages(out.items, large, book.view.paper, book.margin);
  return out;
}

}  // namespace burin
