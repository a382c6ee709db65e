#include "cairo_loader.h"

#include "beside.h"

namespace burin {
namespace {

const CairoLibrary& load() {
  const LibraryWords words{"writes PDF and PNG", "or write SVG"};
  const auto entry = reinterpret_cast<CairoLibraryEntry>(
      library_entry(BURIN_CAIRO_LIBRARY, kCairoLibraryEntry, words));
  const CairoLibrary& cairo = *entry();
  check_library_version(BURIN_CAIRO_LIBRARY, cairo.version, words);
  return cairo;
}

}  // namespace

const CairoLibrary& cairo_library() {
  static const CairoLibrary& cairo = load();
  return cairo;
}

}  // namespace burin
