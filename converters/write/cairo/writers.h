#pragma once
/// The writers in libburin_cairo.

#include <burin/converters/write.h>

#include <iosfwd>
#include <span>

namespace burin {

/// A page a drawing, of its sheet's size, texts as letters of the embedded font; what the file is
/// called is what the first is.
void write_pdf(std::span<const Drawing* const> pages, const WriteOptions& options,
               std::ostream& out, const RunContext& context);

/// The same with each of `Drawing::inks` as a colour space (Separation) and grey lines as tints of
/// black that print over what is below them. Cairo has no such colours. @cite PDF17
void write_pdf_with_inks(std::span<const Drawing* const> pages, const WriteOptions& options,
                         std::ostream& out, const RunContext& context);

/// Grey, one byte a pixel (two with a transparent background).
void write_png(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
               const RunContext& context);

}  // namespace burin
