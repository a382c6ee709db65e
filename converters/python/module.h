#pragma once
/// The units of the Python module; each adds its functions and classes.

#include <pybind11/pybind11.h>

namespace burin::python {

namespace py = pybind11;

void add_errors(py::module_& module);
void add_run(py::module_& module);
void add_scene(py::module_& module);
void add_drawing(py::module_& module);
void add_draw(py::module_& module);
void add_book(py::module_& module);
void add_diff(py::module_& module);
void add_illustration(py::module_& module);
void add_styles(py::module_& module);
void add_plugins(py::module_& module);

/// Classes and errors say that they are of the package, not of the library in it.
template <class Class>
Class& of_package(Class& c) {
  c.attr("__module__") = "burin";
  return c;
}

}  // namespace burin::python
