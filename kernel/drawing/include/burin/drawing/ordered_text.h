#pragma once
/// Text formatted by all cores and written in order.

#include <burin/base/run_context.h>
#include <burin/drawing/text.h>

#include <cstddef>
#include <functional>
#include <iosfwd>

namespace burin {

/// Writes the text of the items 0..n-1, which `format(i, buffer)` appends, in their order.
/// `weight(i)` is about the number of points in an item and decides, alone, which items share a
/// piece of work. Holds the text of a few hundred thousand points at a time. Throws Cancelled.
void write_ordered(std::size_t n, const std::function<std::size_t(std::size_t)>& weight,
                   const std::function<void(std::size_t, Buffer&)>& format, std::ostream& out,
                   const RunContext& context);

}  // namespace burin
