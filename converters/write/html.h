#pragma once
/// A page with the drawing and its parts list.

#include <burin/converters/write.h>

#include <iosfwd>

namespace burin {

/// One file that needs no other and no network: the drawing as SVG beside its items as a table.
/// Pointing at either marks the other; search, keyboard and print are part of it. A drawing without
/// items lists its parts by name.
void write_html(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                const RunContext& context);

}  // namespace burin
