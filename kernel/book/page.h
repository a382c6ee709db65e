#pragma once
// One page of a step book; internal to the module.

#include <burin/book/book.h>

#include "new_parts.h"
#include "scales.h"
#include "show.h"

#include <string>
#include <vector>

namespace burin::detail {

/// What goes on at a step, where its parts are.
struct Scenery {
  Scene scene;
  std::vector<Vec3> moved;
  std::vector<Curve3> trails;
};

/// Where small pictures stand.
struct CellGrid {
  Box2 box;
  std::size_t columns = 0, shown = 0, left_out = 0;
};

/// What a page shows and where, before its scale is chosen.
struct PagePlan {
  Scenery scenery;
  Look look;
  std::vector<NewKind> added;
  CellGrid grid{};
  Annotations over{};
  /// Of the step itself, and the largest scale at which it fits there.
  Box2 box{};
  double fitted = 1;
};

/// All that pages have in common.
struct PageMaker {
  const Scene& scene;
  const ExplodeModel& model;
  const BookOptions& book;
  const Style& style;
  const IllustrateOptions& options;
  std::vector<bool> drawn;
  /// By part.
  std::vector<const DrawingItem*> item_of;
  RunContext& context;

  /// `number` begins with 1.
  PagePlan plan(const BuildStep& step, std::size_t number) const;
  BookPage draw(const BuildStep& step, std::size_t number, const PagePlan& plan,
                const PageScale& scale) const;
};

}  // namespace burin::detail
