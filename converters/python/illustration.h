#pragma once
/// Illustrations as Python has them: a file, or a mapping as it holds.

#include <burin/converters/illustration.h>

#include <pybind11/pybind11.h>

namespace burin::python {

namespace py = pybind11;

/// Of a mapping or a path. Throws UsageError, InputError.
IllustrationFile illustration_of(const py::object& source);
/// Of a mapping without parts, and without "burin". Throws TypeError, UsageError.
DrawRequest settings_of(const py::object& mapping);

}  // namespace burin::python
