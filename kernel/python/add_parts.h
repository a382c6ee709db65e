#pragma once
/// Shapes from Python's memory as parts of a scene. To be called with the GIL, which is released
/// while the kernel works.

#include <burin/surface/scene.h>

#include <pybind11/pybind11.h>

#include <string>

namespace burin::python {

namespace py = pybind11;

/// What no shape says of itself.
struct PartNames {
  std::string name;
  std::string color;
  py::object assembly;
  std::string source;
};

Part brep_part(const py::object& brep, const py::object& placement);
Part mesh_part(const py::object& vertices, const py::object& triangles, const std::string& name,
               Diagnostics& diagnostics);
Part function_part(const py::object& values, const py::object& bounds, const py::object& gradients,
                   const py::object& hessians);
Part implicit_part(const std::string& text, const py::object& bounds);

}  // namespace burin::python
