#pragma once
/// A function that Python evaluates.

#include <burin/base/box.h>
#include <burin/forms/implicit/implicit_function.h>

#include <pybind11/pybind11.h>

#include <memory>

namespace burin::python {

namespace py = pybind11;

/// `values` takes points (n, 3) and gives (n,); `gradients` (n, 3) and `hessians` (n, 3, 3) may be
/// None: central differences, whose steps are shares of the size of the bounds.
struct PythonFunctions {
  py::object values, gradients, hessians;
};

/// With the GIL. Throws TypeError where one is no function.
std::shared_ptr<const ImplicitFunction> make_python_function(const PythonFunctions& functions,
                                                             const Box3& bounds);

}  // namespace burin::python
