#include "cairo_loader.h"

#include "beside.h"

namespace burin {
namespace {

const CairoLibrary& load() {
  const LibraryWords words{"writes PDF and PNG", "or write SVG"};
  const auto door = reinterpret_cast<CairoLibraryDoor>(
      library_door(BURIN_CAIRO_LIBRARY, kCairoLibraryDoor, words));
  const CairoLibrary& cairo = *door();
  check_library_version(BURIN_CAIRO_LIBRARY, cairo.version, words);
  return cairo;
}

}  // namespace

const CairoLibrary& cairo_library() {
  static const CairoLibrary& cairo = load();
  return cairo;
}

}  // namespace burin
