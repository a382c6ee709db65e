#include "arrays.h"

#include <burin/base/error.h>

#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace burin::python {

void need_numpy() {
  try {
    py::module_::import("numpy");
  } catch (py::error_already_set& e) {
    if (!e.matches(PyExc_ModuleNotFoundError)) throw;
    py::raise_from(e, PyExc_ModuleNotFoundError,
                   "arrays need numpy, which this Python does not have: install it, as with pip "
                   "install numpy or, on Debian, apt install python3-numpy");
    throw py::error_already_set();
  }
}

py::array view(const double* data, std::vector<py::ssize_t> shape, const py::handle& owner) {
  need_numpy();
  py::array array(py::dtype::of<double>(), std::move(shape), data,
                  py::reinterpret_borrow<py::object>(owner));
  array.attr("flags").attr("writeable") = false;
  return array;
}

py::array to_array(Vec2 v) { return own<double>({v.x, v.y}, {2}); }
py::array to_array(Vec3 v) { return own<double>({v.x, v.y, v.z}, {3}); }

Doubles matrix(const py::object& value, const char* name, py::ssize_t columns) {
  need_numpy();
  Doubles array = Doubles::ensure(value);
  if (!array) {
    PyErr_Clear();
    throw UsageError(fmt::format("argument {} takes an array of numbers (n, {})", name, columns));
  }
  if (array.ndim() != 2 || array.shape(1) != columns) {
    const std::string shape = py::str(array.attr("shape"));
    throw UsageError(fmt::format("argument {} takes an array (n, {}), not one of shape {}", name,
                                 columns, shape));
  }
  return array;
}

std::vector<Vec3> points(const py::object& value, const char* name) {
  const Doubles array = matrix(value, name, 3);
  std::vector<Vec3> out(static_cast<std::size_t>(array.shape(0)));
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  if (!out.empty()) std::memcpy(out.data(), array.data(), out.size() * sizeof(Vec3));
  return out;
}

}  // namespace burin::python
