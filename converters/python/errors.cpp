#include <burin/base/error.h>
#include <burin/base/missing_file.h>
#include <burin/base/out_of_memory.h>
#include <burin/converters/messages.h>

#include "module.h"

#include <fmt/format.h>

#include <cerrno>
#include <exception>
#include <string>

namespace burin::python {
namespace {

/// Made once and never freed: Python may ask for them until its very end.
struct Errors {
  PyObject *error, *usage, *input, *missing, *geometry, *output, *cancelled;
};
Errors g_errors;

PyObject* make(py::module_& module, const char* name, const char* doc, const py::tuple& bases,
               const py::dict& attributes = {}) {
  const std::string full = fmt::format("burin.{}", name);
  PyObject* type =
      PyErr_NewExceptionWithDoc(full.c_str(), doc, bases.ptr(), attributes.inc_ref().ptr());
  if (!type) throw py::error_already_set();
  module.attr(name) = py::handle(type);
  return type;
}

std::string said(const std::exception& e) { return error_message(e, Spelling::Keywords); }

/// Sets a Python error that has the place as attributes.
void set(PyObject* type, const std::string& message, const std::string& file, std::int64_t line) {
  const py::object error = py::handle(type)(message);
  error.attr("file") = file;
  if (type == g_errors.input || type == g_errors.missing) error.attr("line") = line;
  // What FileNotFoundError has; its text stays that of burin, which names the file too.
  if (type == g_errors.missing) error.attr("errno") = ENOENT;
  PyErr_SetObject(type, error.ptr());
}

// NOLINTNEXTLINE(performance-unnecessary-value-param): as pybind11 wants it
void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const Cancelled& e) {
    PyErr_SetString(g_errors.cancelled, said(e).c_str());
  } catch (const UsageError& e) {
    PyErr_SetString(g_errors.usage, said(e).c_str());
  } catch (const MissingFile& e) {
    set(g_errors.missing, said(e), e.file(), e.line());
  } catch (const InputError& e) {
    set(g_errors.input, said(e), e.file(), e.line());
  } catch (const GeometryError& e) {
    PyErr_SetString(g_errors.geometry, said(e).c_str());
  } catch (const OutputError& e) {
    set(g_errors.output, said(e), e.file(), 0);
  } catch (const Error& e) {
    PyErr_SetString(g_errors.error, said(e).c_str());
  } catch (const std::exception& e) {
    if (!is_out_of_memory(e)) throw;
    PyErr_SetString(PyExc_MemoryError, "out of memory; draw a smaller model, or fewer at once");
  }
}

}  // namespace

void add_errors(py::module_& module) {
  const auto builtin = [](PyObject* type) { return py::reinterpret_borrow<py::object>(type); };
  const py::tuple exception = py::make_tuple(builtin(PyExc_Exception));
  g_errors.error = make(module, "Error", "What all errors of this module are.", exception);
  const py::object error = builtin(g_errors.error);
  const auto derive = [&](const char* name, const char* doc, const py::dict& attributes = {}) {
    return make(module, name, doc, py::make_tuple(error), attributes);
  };
  g_errors.usage = make(module, "UsageError", "An argument or option that makes no sense.",
                        py::make_tuple(error, builtin(PyExc_ValueError)));
  py::dict place;
  place["file"] = "";
  place["line"] = 0;
  g_errors.input = derive(
      "InputError",
      "A file that is missing, broken or empty. Attributes: file (str), line (int, 0 = unknown).",
      place);
  g_errors.missing =
      make(module, "MissingFile", "An input that is not there, also a FileNotFoundError.",
           py::make_tuple(builtin(g_errors.input), builtin(PyExc_FileNotFoundError)));
  g_errors.geometry = derive("GeometryError", "A shape that cannot be drawn.");
  py::dict file;
  file["file"] = "";
  g_errors.output =
      make(module, "OutputError", "A file that cannot be written. Attribute: file (str).",
           py::make_tuple(error, builtin(PyExc_OSError)), file);
  g_errors.cancelled = derive("Cancelled", "The run was cancelled.");
  py::register_local_exception_translator(translate);
}

}  // namespace burin::python
