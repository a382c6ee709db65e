#pragma once
/// Direction fields and tones that Python evaluates.

#include <burin/illustrate/illustrate.h>

#include <pybind11/pybind11.h>

#include <functional>

namespace burin::python {

namespace py = pybind11;

/// `function` takes positions (n, 3) and unit normals (n, 3) and gives directions (n, 3). It is
/// asked once for all samples of the picture, by the thread that waits for the run; strokes follow
/// what lies between them. Where no sample is near it is asked for that place.
std::function<Field(const HatchScene&)> python_field(const py::object& function);
/// The same for the wanted darkness (n,) in [0, 1].
std::function<Tone(const HatchScene&)> python_tone(const py::object& function);

}  // namespace burin::python
