#include "read.h"

#include <burin/converters/request.h>

#include "text.h"

namespace burin::python {
namespace {

/// A value as OpenSCAD writes it.
std::string literal(const std::string& name, const py::handle& value) {
  if (py::isinstance<py::str>(value)) {
    std::string text = "\"";
    for (const char c : value.cast<std::string>()) {
      if (c == '"' || c == '\\') text += '\\';
      text += c;
    }
    return text + "\"";
  }
  const std::string text = value_text(name.c_str(), value);
  return py::isinstance<py::iterable>(value) ? "[" + text + "]" : text;
}

/// What one keyword means on the command line: an option for each entry of a mapping
/// (define={"teeth": 12}) or of a list of texts.
std::vector<std::string> texts(const std::string& name, const py::handle& value) {
  std::vector<std::string> out;
  if (is_mapping(value)) {
    for (const py::handle item : value.attr("items")()) {
      const auto pair = item.cast<py::tuple>();
      out.push_back(pair[0].cast<std::string>() + "=" + literal(name, pair[1]));
    }
    return out;
  }
  const bool list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  if (list && py::len(value) > 0 && py::isinstance<py::str>(value[py::int_(0)])) {
    for (const py::handle item : value) out.push_back(item.cast<std::string>());
    return out;
  }
  return {value_text(name.c_str(), value)};
}

}  // namespace

ReadOptions read_options(const py::object& bounds, const py::kwargs& options,
                         const std::vector<std::string>& others) {
  ReadRequest request;
  request.bounds = list_text("bounds", bounds);
  for (const auto& [key, value] : options) {
    const auto name = key.cast<std::string>();
    for (const std::string& text : texts(name, value)) set_read_option(request, name, text, others);
  }
  return make_read_options(request, Spelling::Keywords);
}

}  // namespace burin::python
