#pragma once
/// Styles as Python has them.

#include <burin/converters/request.h>

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace burin::python {

namespace py = pybind11;

/// A name, a path or a mapping as a style file has it.
void set_style(DrawRequest& request, const py::object& style);
/// The style that such a value means. Throws UsageError, InputError.
Style style_of(const py::object& value);
/// {"name": ..., "line.outer": 0.7, ...}.
py::dict flat(const Style& style);
/// A mapping of style keys, or of groups of them, as "KEY=VALUE".
std::vector<std::string> assignments(const py::object& mapping);

}  // namespace burin::python
