#pragma once
/// numpy arrays and the kernel's vectors.

#include <burin/base/vec.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <string>
#include <vector>

namespace burin::python {

namespace py = pybind11;

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Throws ModuleNotFoundError that says what to install where there is no numpy: the rest of the
/// module needs none.
void need_numpy();

/// Takes the numbers of `values` over into an array of the shape, which owns them.
template <class T>
py::array own(std::vector<T> values, std::vector<py::ssize_t> shape) {
  need_numpy();
  auto* kept = new std::vector<T>(std::move(values));  // NOLINT(cppcoreguidelines-owning-memory)
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array(py::dtype::of<T>(), std::move(shape), kept->data(), owner);
}

/// An array that cannot be written to, over memory that `owner` keeps.
py::array view(const double* data, std::vector<py::ssize_t> shape, const py::handle& owner);

py::array to_array(Vec2 v);
py::array to_array(Vec3 v);

/// (n, columns) doubles. Throws UsageError that names the argument and its shape.
Doubles matrix(const py::object& value, const char* name, py::ssize_t columns);

/// Points (n, 3) as vectors.
std::vector<Vec3> points(const py::object& value, const char* name);

}  // namespace burin::python
