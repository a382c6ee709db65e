#pragma once
/// Keywords about reading.

#include <burin/converters/read.h>

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace burin::python {

namespace py = pybind11;

/// Throws UsageError that names the nearest, of these and of `others`, where a keyword is unknown.
ReadOptions read_options(const py::object& bounds, const py::kwargs& options,
                         const std::vector<std::string>& others = {});

}  // namespace burin::python
