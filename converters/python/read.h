#pragma once
/// Keywords as the options that they are.

#include <burin/converters/request.h>

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace burin::python {

namespace py = pybind11;

/// The keyword of an option, unless its value is None: as the text that the command line would
/// have. Throws TypeError for a value of the wrong type.
void add_keyword(DrawRequest& request, const RequestOption& option, const py::handle& value);

/// Keywords about reading. Throws UsageError that names the nearest, of these and of `others`,
/// where one is unknown.
ReadOptions read_options(const py::kwargs& keywords, const std::vector<std::string>& others = {});

}  // namespace burin::python
