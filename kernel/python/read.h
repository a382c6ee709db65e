#pragma once
/// Keywords about reading.

#include <burin/converters/read.h>

#include <pybind11/pybind11.h>

namespace burin::python {

namespace py = pybind11;

/// Throws UsageError that names the nearest where a keyword is unknown.
ReadOptions read_options(const py::object& bounds, const py::kwargs& options);

}  // namespace burin::python
