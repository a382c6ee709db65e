#pragma once
/// The writers behind the door of libburin_cairo.

#include <burin/converters/write.h>

#include <iosfwd>

namespace burin {

/// One page of the sheet's size, all ink black, no fonts.
void write_pdf(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
               const RunContext& context);

/// Grey, one byte a pixel (two with a transparent background).
void write_png(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
               const RunContext& context);

}  // namespace burin
