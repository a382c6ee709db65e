#include <burin/annotate/list_pages.h>
#include <burin/book/book.h>
#include <burin/drawing/views.h>

#include "page.h"

#include <fmt/format.h>

#include <utility>

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
  for (const BuildStep& step : build_steps(scene, drawn, steps, item_of, book.build)) {
    context.check();
    out.pages.push_back(maker.make(step, out.pages.size() + 1));
    append_new(of_page(out.pages.back().drawing.diagnostics, out.pages.size()), out.diagnostics);
  }
  CalloutOptions large = style.callout;
  large.list_height *= 1.4;  // a sheet of its own has room
  out.lists = list_pages(out.items, large, book.view.paper, book.margin);
  return out;
}

}  // namespace burin
