#pragma once
/// The entry point of libburin_cairo: one symbol, `burin_cairo_library`, which gives this.

#include <burin/converters/write.h>

#include <iosfwd>
#include <span>

namespace burin {

/// Both sides are built together and share libburin: C++ types and exceptions pass. `version` must
/// be looked at before anything else is used.
struct CairoLibrary {
  using Writer = void (*)(const Drawing& drawing, const WriteOptions& options, std::ostream& out,
                          const RunContext& context);
  const char* version;
  void (*write_pdf)(std::span<const Drawing* const> pages, const WriteOptions& options,
                    std::ostream& out, const RunContext& context);
  Writer write_png;
};

inline constexpr const char* kCairoLibraryEntry = "burin_cairo_library";
using CairoLibraryEntry = const CairoLibrary* (*)();

}  // namespace burin
