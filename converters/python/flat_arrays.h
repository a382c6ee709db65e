#pragma once
/// A drawing as a few long arrays.

#include <burin/drawing/drawing.h>

#include <pybind11/pybind11.h>

namespace burin::python {

/// See Drawing.arrays of the module. With the GIL. Cost: 0.03 s for 100,000 paths of 10 points.
pybind11::dict flat_arrays(const Drawing& drawing);

/// See Drawing.areas. With the GIL.
pybind11::list area_dicts(const Drawing& drawing);

}  // namespace burin::python
