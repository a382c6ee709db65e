// In the place of cairo_loader.cpp where Burin was built without cairo (BURIN_PICTURES).

#include <burin/base/error.h>

#include "absent.h"
#include "cairo_loader.h"

namespace burin {

const CairoLibrary& cairo_library() { throw UsageError(needs("PDF files", kWithPictures)); }

}  // namespace burin
