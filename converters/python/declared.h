#pragma once
/// Options that programs declare, and their values as Python has them.

#include <burin/options/declared.h>

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>
#include <vector>

namespace burin::python {

namespace py = pybind11;

/// A text that lives as long as the program, as rows of catalogues ask for.
std::string_view kept(const std::string& text);

/// `name` where it is one of a factory: a-z, 0-9 and -. Throws UsageError.
std::string checked_name(const std::string& name);

/// From {"climb": {"default": 15.0, "low": 0, "high": 90, "unit": "degrees", "meaning": "..."}}:
/// the type of "default" tells the kind, "words" a list to choose from. Throws UsageError,
/// TypeError.
std::vector<DeclaredOption> declared_options(const py::object& options);

/// {"climb": 15.0}; with the GIL.
py::dict to_dict(const std::vector<DeclaredOption>& declared,
                 const std::vector<OptionValue>& values);

}  // namespace burin::python
