#pragma once
/// A Python object that threads without the GIL may own.

#include "run.h"

#include <pybind11/pybind11.h>

#include <memory>

namespace burin::python {

/// The object is let go with the GIL, wherever the last owner is. At the very end of Python it is
/// not let go at all.
inline std::shared_ptr<py::object> hold(py::object object) {
  return {new py::object(std::move(object)), [](py::object* held) {
            if (!Py_IsInitialized()) return;
            const py::gil_scoped_acquire gil;
            delete held;  // NOLINT(cppcoreguidelines-owning-memory)
          }};
}

}  // namespace burin::python
