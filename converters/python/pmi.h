#pragma once
/// The dimensions, tolerances, datums and notes of a scene in Python.

#include <burin/surface/scene.h>

#include <pybind11/pybind11.h>

namespace burin::python {

namespace py = pybind11;

/// A dict each: what `burin info --json` tells of it, its part, and how the file shows it.
py::list pmi_of(const Scene& scene);

}  // namespace burin::python
