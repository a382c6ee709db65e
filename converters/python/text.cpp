#include "text.h"

#include <fmt/format.h>

#include <string_view>

namespace burin::python {
namespace {

/// Python's and numpy's.
bool is_bool(const py::handle& value) {
  const std::string_view type = Py_TYPE(value.ptr())->tp_name;
  return PyBool_Check(value.ptr()) || type == "numpy.bool_" || type == "numpy.bool";
}

bool is_number(const py::handle& value) {
  return !is_bool(value) && PyNumber_Check(value.ptr()) &&
         !(PyObject_HasAttrString(value.ptr(), "__len__"));
}

std::string text_of_number(const py::handle& value) {
  if (PyIndex_Check(value.ptr())) {
    const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!whole) throw py::error_already_set();
    return py::str(whole);
  }
  const double real = PyFloat_AsDouble(value.ptr());
  if (real == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
  return py::repr(py::float_(real));  // numpy 2 writes its own as "np.float64(0.1)"
}

}  // namespace

std::string number_text(const char* name, const py::handle& value) {
  if (value.is_none()) return {};
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (!is_number(value)) {
    throw py::type_error(
        fmt::format("argument {} takes a number, not {}", name, std::string(py::repr(value))));
  }
  return text_of_number(value);
}

std::string list_text(const char* name, const py::handle& value, const char* separator) {
  if (value.is_none()) return {};
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (!py::isinstance<py::iterable>(value)) {
    throw py::type_error(
        fmt::format("argument {} takes numbers, not {}", name, std::string(py::repr(value))));
  }
  std::string text;
  for (const py::handle item : py::reinterpret_borrow<py::object>(value)) {
    // Rows: boxes are (2, 3) arrays as Scene.bounds() gives them.
    if (!py::isinstance<py::str>(item) && py::isinstance<py::sequence>(item)) {
      text += (text.empty() ? "" : separator) + list_text(name, item, separator);
      continue;
    }
    if (!is_number(item)) {
      throw py::type_error(
          fmt::format("argument {} takes numbers, not {}", name, std::string(py::repr(value))));
    }
    text += (text.empty() ? "" : separator) + text_of_number(item);
  }
  return text;
}

std::string value_text(const char* name, const py::handle& value) {
  if (is_bool(value)) return PyObject_IsTrue(value.ptr()) == 1 ? "true" : "false";
  if (is_number(value)) return text_of_number(value);
  return list_text(name, value);
}

bool is_mapping(const py::handle& value) {
  return PyMapping_Check(value.ptr()) && PyObject_HasAttrString(value.ptr(), "items");
}

std::string path_text(const py::handle& value) {
  const auto path = py::reinterpret_steal<py::object>(PyOS_FSPath(value.ptr()));
  if (!path) throw py::error_already_set();
  return py::isinstance<py::bytes>(path)
             ? path.cast<std::string>()
             : py::module_::import("os").attr("fsencode")(path).cast<std::string>();
}

std::vector<std::string> path_list(const py::handle& value) {
  const bool one = py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) ||
                   PyObject_HasAttrString(value.ptr(), "__fspath__");
  if (one) return {path_text(value)};
  if (!py::isinstance<py::iterable>(value)) {
    throw py::type_error(fmt::format("takes a scene, a path or several paths, not {}",
                                     std::string(py::repr(value))));
  }
  std::vector<std::string> paths;
  for (const py::handle item : py::reinterpret_borrow<py::object>(value)) {
    paths.push_back(path_text(item));
  }
  return paths;
}

}  // namespace burin::python
