#pragma once
// What a step adds; internal to the module.

#include <burin/book/book.h>

#include <cstddef>
#include <vector>

namespace burin::detail {

struct PageMaker;

/// New things of a page that are alike, with the parts of one of them.
struct NewKind {
  NewPart about;
  std::vector<std::size_t> parts;
};

/// In the order of the step's moves; where it begins, then what stands there already.
std::vector<NewKind> new_kinds(const PageMaker& maker, const BuildStep& step);

/// Items of what is new, with those of their parts that are on the page.
std::vector<DrawingItem> new_items(const PageMaker& maker, const BuildStep& step);

}  // namespace burin::detail
