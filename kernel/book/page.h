#pragma once
// One page of a step book; internal to the module.

#include <burin/book/book.h>

#include <map>
#include <vector>

namespace burin::detail {

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
  BookPage make(const BuildStep& step, std::size_t number) const;
};

}  // namespace burin::detail
