#pragma once
/// Step books: how a product is put together, a page a step, and what it is made of.

#include <burin/arrange/illustration.h>
#include <burin/book/build_steps.h>
#include <burin/camera/sheet.h>
#include <burin/illustrate/illustrate.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin {

/// What a page adds: instances of one item, or sub-assemblies alike.
struct NewPart {
  /// 0: a sub-assembly.
  int item = 0;
  std::string name;
  std::size_t quantity = 0;
};

struct BookPage {
  /// The name of the sub-assembly that is put together and how many are needed; of the whole:
  /// empty.
  std::string title;
  std::vector<NewPart> added;
  /// Of the step, paper mm a model mm (perspective: in the plane of its middle).
  double scale = 1;
  /// Number of the step, small pictures of what is new, and the step: what is new before its place,
  /// with a line to it, the rest in light lines.
  Drawing drawing;
};

struct Book {
  std::string title;
  /// One a step, in order.
  std::vector<BookPage> pages;
  /// The parts list.
  std::vector<DrawingItem> items;
  /// Sheets with the parts list, for formats of sheets.
  std::vector<Drawing> lists;
  Diagnostics diagnostics;
};

struct BookOptions {
  /// Direction, up, perspective, scale and paper are looked at. A page that has no room for the
  /// scale is drawn as large as it fits, with a warning.
  ViewOptions view{};
  Margin margin{};
  BuildOptions build{};
  /// Numbers with leaders at what is new.
  bool callouts = false;
  /// Steps have scales of ISO 5455.
  bool iso_scale = false;
};

/// Draws the book of a scene that stands together. `steps` take it apart; `model` is of the same
/// scene and the parts that are drawn; `options.annotations` has the items of these. A step is
/// looked at from the asked direction, unless less than 30 % of the silhouette of something new is
/// seen from there: then from another of eight, and what hides it still becomes a ghost. Successive
/// steps of one assembly have one scale, unless one of them could be drawn more than twice as
/// large; a page whose scale is not that of the page before says it. What one drawing would tell of
/// the scene is told once. Throws as `illustrate`. Cost: that of the drawings, one large and some
/// small ones a step.
Book make_book(const Scene& scene, const ExplodeModel& model, const std::vector<ExplodeStep>& steps,
               const BookOptions& book, const Style& style, const IllustrateOptions& options,
               RunContext& context);
/// The same of an illustration, by the steps of its exploded view read backwards, or by those that
/// are found; parts are chosen, numbered and cut as it says. Throws UsageError where its sheet has
/// no size, and as `arrange_parts`.
Book make_book(Scene& scene, Illustration& illustration, const BuildOptions& build,
               RunContext& context);

}  // namespace burin
