#include <burin/arrange/arrange.h>
#include <burin/base/error.h>
#include <burin/book/book.h>

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

Book make_book(Scene& scene, Illustration& illustration, const BuildOptions& build,
               RunContext& context) {
  if (illustration.sheet.fits) {
    throw UsageError("the pages of a step book have one size: give `paper` one");
  }
  check_iso_scale(illustration.view, illustration.sheet);
  illustration.items = true;
  select_parts(scene, illustration);
  number_parts(scene, illustration, context);
  find_threads(scene, illustration, context);
  const std::vector<bool> drawn = drawn_parts(scene, illustration.illustrate.part_styles);
  const ExplodeModel model(scene, drawn, context);
  const std::vector<ExplodeStep> steps =
      explode_steps(scene, illustration.explode, drawn, model, context);
  cut_parts(scene, illustration);
  const BookOptions options{.view = illustration.view,
                            .margin = illustration.sheet.margin,
                            .build = build,
                            .callouts = illustration.callouts,
                            .iso_scale = illustration.sheet.iso_scale};
  Book book =
      make_book(scene, model, steps, options, illustration.style, illustration.illustrate, context);
  book.title = illustration.title.empty() ? name_of(scene, drawn) : illustration.title;
  return book;
}

}  // namespace burin
