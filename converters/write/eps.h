#pragma once
/// Encapsulated PostScript.

#include <burin/converters/write.h>

#include <iosfwd>

namespace burin {

/// One picture whose bounding box is the sheet. Places are whole micrometres, so that nothing adds
/// up. Level 2, no fonts.
void write_eps(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
               const RunContext& context);

}  // namespace burin
