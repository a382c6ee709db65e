#pragma once
/// Layers, paths and views of a drawing as Python holds them.

#include "drawing.h"

#include <cstddef>

namespace burin::python {

/// A layer, and a path of it; both keep the drawing.
struct PyLayer {
  DrawingOwner owner;
  std::size_t index = 0;

  const Layer& layer() const { return owner->drawing.layers[index]; }
};
struct PyPath {
  DrawingOwner owner;
  std::size_t layer = 0, index = 0;

  const Path& path() const { return owner->drawing.layers[layer].paths[index]; }
};
struct PyView {
  DrawingView view;
};

void add_lines(pybind11::module_& module);

}  // namespace burin::python
