#include <burin/base/error.h>
#include <burin/camera/standards.h>
#include <burin/converters/request.h>
#include <burin/converters/write.h>
#include <burin/illustrate/style.h>

#include "module.h"
#include "style_text.h"
#include "text.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

namespace burin::python {
namespace {

/// What JSON has no words for: numpy's numbers and arrays, tuples of them.
py::object plain(const py::object& value) {
  if (PyObject_HasAttrString(value.ptr(), "tolist")) return value.attr("tolist")();
  throw py::type_error(
      fmt::format("style: {} is no value of a style key", std::string(py::repr(value))));
}

/// The entries of a mapping; {"hatch": {"taper": 1}} is {"hatch.taper": 1}.
void append_assignments(const py::handle& mapping, const std::string& group,
                        std::vector<std::string>& out) {
  if (!is_mapping(mapping)) throw py::type_error("argument set takes a mapping of style keys");
  for (const py::handle item : mapping.attr("items")()) {
    const auto pair = item.cast<py::tuple>();
    if (!py::isinstance<py::str>(pair[0])) {
      throw py::type_error(fmt::format("argument set: {} is no style key, which is text",
                                       std::string(py::repr(pair[0]))));
    }
    const auto key = group + pair[0].cast<std::string>();
    if (group.empty() && is_mapping(pair[1])) {
      append_assignments(pair[1], key + ".", out);
    } else {
      out.push_back(key + "=" + value_text(key.c_str(), pair[1]));
    }
  }
}

}  // namespace

py::dict flat(const Style& style) {
  py::dict out;
  const py::dict json = py::module_::import("json").attr("loads")(style_to_json(style));
  for (const auto& [group, members] : json) {
    if (!py::isinstance<py::dict>(members)) {
      out[group] = members;
      continue;
    }
    for (const auto& [key, value] : members.cast<py::dict>()) {
      out[py::str("{}.{}").format(group, key)] = value;
    }
  }
  return out;
}

Style style_of(const py::object& value) {
  DrawRequest request;
  set_style(request, value);
  return make_plan(request, Spelling::Keywords).style;
}

void set_style(DrawRequest& request, const py::object& style) {
  if (!is_mapping(style)) {
    request.options["style"] = {path_text(style)};
    return;
  }
  const py::object dumps = py::module_::import("json").attr("dumps");
  request.style_text = dumps(py::module_::import("builtins").attr("dict")(style),
                             py::arg("default") = py::cpp_function(plain))
                           .cast<std::string>();
}

std::vector<std::string> assignments(const py::object& mapping) {
  std::vector<std::string> out;
  append_assignments(mapping, "", out);
  return out;
}

void add_styles(py::module_& module) {
  module.def(
      "styles",
      [] {
        py::dict out;
        for (const StyleInfo& s : builtin_styles()) out[py::str(s.name)] = s.description;
        return out;
      },
      "Names of the built-in styles with what they are for.");
  module.def(
      "style", [](const py::object& name) { return flat(style_of(name)); }, py::arg("name"),
      "All keys of a style with their values, {\"name\": ..., \"line.outer\": 0.7, ...}; lengths "
      "in mm "
      "of paper. Takes what `style` of `draw` takes, and gives what it takes.");
  module.def(
      "style_keys",
      [](const py::object& style) {
        const py::object loads = py::module_::import("json").attr("loads");
        py::list out;
        for (const StyleKey& k : style_keys(style_of(style))) {
          out.append(
              loads(to_json(k, {{"key", k.name}, {"value", k.value}, {"scope", k.scope()}})));
        }
        return out;
      },
      py::arg("style") = "technical",
      "Each key of a style: \"key\", \"meaning\", \"kind\" (number, flag, word, direction or "
      "text), "
      "what it takes (\"low\", \"high\", \"unit\"; \"words\"; \"takes\" for people), \"value\", "
      "\"scope\" (drawing: parts in a style of their own cannot have another; part: they can); "
      "keys "
      "of kinds of strokes after the first among them.");
  module.def(
      "formats", [] { return format_names(); },
      "Suffixes that `Drawing.save` writes, e.g. \"svg\".");
  module.def(
      "views",
      [] {
        py::dict out;
        for (const StandardView& v : standard_views()) {
          const auto [d, u] = v.view;
          out[py::str(std::string(v.name))] =
              py::make_tuple(py::make_tuple(d.x, d.y, d.z), py::make_tuple(u.x, u.y, u.z));
        }
        return out;
      },
      "Names that `view` takes, each with the direction from the model to the viewer, and up.");
  module.def(
      "papers",
      [] {
        py::dict out;
        for (const StandardPaper& p : standard_papers()) {
          out[py::str(std::string(p.name))] = py::make_tuple(p.longer, p.shorter);
        }
        return out;
      },
      "Names that `paper` takes, each with width and height in mm; with a trailing p it is "
      "upright.");
}

}  // namespace burin::python
