#pragma once
/// Drawings as Python holds them.

#include <burin/drawing/drawing.h>
#include <burin/illustrate/style.h>

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace burin::python {

struct PyDrawing {
  Drawing drawing;
  /// Says how files are written.
  Style style;
  std::string id_prefix = {};
};

using DrawingOwner = std::shared_ptr<PyDrawing>;

/// A dict an item.
pybind11::list to_list(const std::vector<DrawingItem>& items);

}  // namespace burin::python
