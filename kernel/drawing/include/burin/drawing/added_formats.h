#pragma once
/// Formats of drawings that plug-ins and programs add.

#include <burin/base/run_context.h>
#include <burin/drawing/drawing.h>
#include <burin/options/declared.h>

#include <functional>
#include <iosfwd>
#include <span>
#include <string_view>
#include <vector>

namespace burin {

struct AddedFormat {
  /// The suffix without its dot; keys of styles about it begin with it ("txt.decimals").
  std::string_view name;
  std::string_view meaning;
  /// Writes the drawing with the values of `options`, in their order; the same bytes for the same
  /// drawing. Throws what says why it cannot.
  std::function<void(const Drawing&, const std::vector<OptionValue>& values, std::ostream&,
                     const RunContext&)>
      write;
  std::vector<DeclaredOption> options{};
};

/// All that were added.
std::span<const AddedFormat> added_formats();

/// Adds a format, or puts it in the place of one of its name. Its texts live as long as the
/// program.
void add(AddedFormat format);

}  // namespace burin
