#pragma once
/// Shapes from Python's memory as parts of a scene. To be called with the GIL, which is released
/// while the kernel works.

#include <burin/converters/cad_reader.h>
#include <burin/mesh/tri_mesh.h>
#include <burin/surface/scene.h>

#include "function.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace burin::python {

namespace py = pybind11;

/// What no shape says of itself.
struct PartNames {
  std::string name;
  std::string color;
  py::object assembly;
  std::string source;
};

/// What Python calls `Brep`.
struct PyBrep {
  std::shared_ptr<const BrepShape> shape;
};

/// "x0,y0,z0,x1,y1,z1" or six numbers; nothing for None.
std::optional<Box3> box_of(const py::object& bounds);

/// Vertices (n, 3), and corners (m, 3) of any integer type, each one of them. Throws UsageError.
PolygonSoup soup_of(const py::object& vertices, const py::object& triangles);

PyBrep read_brep(const py::object& brep);
bool is_valid(const PyBrep& brep);
/// `brep`: a PyBrep, or text. `face_colors`: of each face, "#rrggbb", of glass "#rrggbbaa", or
/// empty, which is `color`; none: all of it has `color`. Throws UsageError where there are more or
/// fewer.
Part brep_part(const py::object& brep, const py::object& placement, const std::string& color,
               std::vector<std::string> face_colors);
Part mesh_part(const py::object& vertices, const py::object& triangles, const py::object& texture,
               const std::string& name, Diagnostics& diagnostics);
/// `samples` along the longest side of the bounds that stand for the function; 0 = the function
/// itself is called for every point.
Part function_part(const PythonFunctions& functions, const py::object& bounds,
                   const py::object& samples);
Part implicit_part(const std::string& text, const py::object& bounds);

}  // namespace burin::python
