#pragma once
/// Drawings as Python holds them.

#include <burin/drawing/drawing.h>
#include <burin/illustrate/style.h>

#include <memory>
#include <string>

namespace burin::python {

struct PyDrawing {
  Drawing drawing;
  /// Says how files are written.
  Style style;
  std::string id_prefix = {};
};

using DrawingOwner = std::shared_ptr<PyDrawing>;

}  // namespace burin::python
