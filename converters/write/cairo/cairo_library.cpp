#include "cairo_library.h"

#include "writers.h"

namespace burin {
namespace {

constexpr CairoLibrary kLibrary{BURIN_CAIRO_VERSION, write_pdf, write_png};

}  // namespace
}  // namespace burin

extern "C" const burin::CairoLibrary* burin_cairo_library() { return &burin::kLibrary; }
