#pragma once
/// Drawings as Python holds them.

#include <burin/drawing/drawing.h>
#include <burin/illustrate/style.h>

#include <memory>

namespace burin::python {

struct PyDrawing {
  Drawing drawing;
  /// Says how files are written.
  Style style;
};

using DrawingOwner = std::shared_ptr<PyDrawing>;

}  // namespace burin::python
