#pragma once
/// Python's values as the text that the command line would have had, so that one place judges both.

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace burin::python {

namespace py = pybind11;

/// A number, exactly; text as it is; "" for None. Throws TypeError that names the argument.
std::string number_text(const char* name, const py::handle& value);
/// Numbers with `separator` between them; text as it is; "" for None.
std::string list_text(const char* name, const py::handle& value, const char* separator = ",");
/// What a style key takes: also True and False.
std::string value_text(const char* name, const py::handle& value);
/// Whether it has keys and values.
bool is_mapping(const py::handle& value);
/// A path as text, of anything that os.fspath takes.
std::string path_text(const py::handle& value);
/// One path or a sequence of them.
std::vector<std::string> path_list(const py::handle& value);

}  // namespace burin::python
