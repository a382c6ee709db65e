#pragma once
/// A page that shows what has changed: the drawing of both revisions beside a table.

#include <burin/base/run_context.h>
#include <burin/converters/write.h>
#include <burin/drawing/drawing.h>

#include <iosfwd>
#include <span>
#include <string>

namespace burin {

/// A row of the table; what is called the same is in one group.
struct DifferenceRow {
  /// Of `Drawing::items`; 0: the drawing shows nothing of it.
  int item = 0;
  /// "added", "removed" ...
  std::string change;
  std::string name;
  /// In words: how far moved, how much larger.
  std::string what;
};

/// One self-contained page of HTML: rows and parts mark each other, buttons show the old revision,
/// both, or the new one. `counts`: the line below the table. Throws Cancelled.
void write_difference_page(const Drawing& drawing, std::span<const DifferenceRow> rows,
                           const std::string& counts, const WriteOptions& options,
                           std::ostream& out, const RunContext& context);

}  // namespace burin
