#include "drawing.h"

#include <burin/base/error.h>
#include <burin/converters/read_drawing.h>
#include <burin/converters/values.h>
#include <burin/converters/write.h>
#include <burin/options/meant.h>

#include "flat_arrays.h"
#include "lines.h"
#include "module.h"
#include "run.h"
#include "scene.h"
#include "text.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <utility>

namespace burin::python {
namespace {

std::string text_of(const py::handle& value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  throw py::type_error(
      fmt::format("argument id_prefix takes text, not {}", std::string(py::repr(value))));
}

/// The style of the drawing with keywords like svg_flatten=True for the key "svg.flatten".
WriteOptions options_of(const PyDrawing& drawing, const py::kwargs& options) {
  Style style = drawing.style;
  std::vector<std::string> keys, names;
  for (const StyleKey& info : style_keys(style)) {
    if (!is_about_files(info.name)) continue;
    keys.push_back(info.name);
    names.push_back(info.name);
    std::replace(names.back().begin(), names.back().end(), '.', '_');
  }
  std::string id_prefix = drawing.id_prefix;
  names.emplace_back("id_prefix");
  for (const auto& [key, value] : options) {
    const auto name = key.cast<std::string>();
    if (name == "id_prefix") {
      id_prefix = id_prefix_option(name, text_of(value));
      continue;
    }
    const auto it = std::find(names.begin(), names.end(), name);
    if (it == names.end()) {
      throw UsageError(
          fmt::format("unknown argument '{}'{}", name, hint(name, known_words(names))));
    }
    set_style_key(style, keys[static_cast<std::size_t>(it - names.begin())],
                  value_text(name.c_str(), value));
  }
  check_style(style);
  WriteOptions write = write_options(style);
  write.svg.id_prefix = id_prefix;
  return write;
}

/// What a format cannot show of a drawing, as warnings of Python.
void warn(const Diagnostics& reported) {
  for (const Diagnostic& one : reported.entries()) {
    if (one.severity == Severity::Info) continue;
    if (PyErr_WarnEx(PyExc_UserWarning, one.message.c_str(), 1) != 0) throw py::error_already_set();
  }
}

void save(const DrawingOwner& self, const py::object& path, const py::kwargs& options) {
  const std::string name = path_text(path);
  if (name.empty()) throw UsageError("the path of the drawing is empty");
  WriteOptions write = options_of(*self, options);
  Diagnostics reported;
  write.report = [&](const Diagnostic& one) { reported.add(one); };
  run(py::none(), nullptr,
      [&](RunContext& context) { write_file(self->drawing, name, write, context); });
  warn(reported);
}

py::bytes to_bytes(const DrawingOwner& self, const std::string& format, const py::kwargs& options) {
  const auto named = format_named(format);
  if (!named) {
    throw UsageError(fmt::format("argument format takes {}, not '{}'", format_list(), format));
  }
  WriteOptions write = options_of(*self, options);
  Diagnostics reported;
  write.report = [&](const Diagnostic& one) { reported.add(one); };
  std::ostringstream out;
  run(py::none(), nullptr,
      [&](RunContext& context) { write_drawing(self->drawing, *named, write, out, context); });
  warn(reported);
  return {out.str()};
}

/// `read` gives a drawing; runs without the GIL.
DrawingOwner made(const std::function<Drawing(const RunContext&)>& read) {
  auto drawing = std::make_shared<PyDrawing>();
  // What files do not say is as in `burin convert`.
  drawing->style = builtin_style("technical");
  run(py::none(), nullptr, [&](RunContext& context) {
    context.begin_stage(RunStage::Read);
    drawing->drawing = read(context);
    context.end_stage();
  });
  return drawing;
}

DrawingOwner load(const py::object& path) {
  const std::string name = path_text(path);
  return made([&](const RunContext& context) { return read_drawing(name, context); });
}

DrawingOwner from_json(const py::object& text) {
  if (!py::isinstance<py::str>(text) && !py::isinstance<py::bytes>(text)) {
    throw py::type_error("argument text takes str or bytes, a drawing file");
  }
  const auto json = text.cast<std::string>();
  return made([&](const RunContext& context) { return parse_drawing(json, "", context); });
}

py::list parts(const PyDrawing& self) {
  py::list list;
  for (const DrawingPart& p : self.drawing.parts) {
    py::dict d;
    d["id"] = p.id;
    d["name"] = p.name;
    d["source"] = p.source;
    d["triangles"] = p.triangles;
    d["faces"] = p.faces;
    d["assembly"] = p.assembly;
    d["color"] = p.color;
    list.append(d);
  }
  return list;
}

py::dict verification(const Verification& v) {
  py::dict d;
  d["spans"] = v.spans;
  d["length"] = v.length;
  d["contradicted"] = v.contradicted;
  d["share"] = v.share();
  d["count"] = v.count;
  d["loose_ends"] = v.loose_ends;
  if (v.area > 0) {
    d["area"] = v.area;
    d["wrong_area"] = v.wrong_area;
    d["wrong_patches"] = v.wrong_patches;
  }
  py::list list;
  for (const Contradiction& c : v.contradictions) {
    py::dict one;
    one["what"] = c.what;
    one["part"] = c.source.part;
    one["face"] = c.source.face;
    if (c.size > 0) {
      one["size"] = c.size;
    } else {
      one["kind"] = to_string(c.kind);
      one["edge"] = c.source.edge;
      one["length"] = c.length;
    }
    one["at"] = py::make_tuple(c.at.x, c.at.y);
    one["model"] = py::make_tuple(c.model.x, c.model.y, c.model.z);
    list.append(one);
  }
  d["contradictions"] = list;
  return d;
}

py::dict stats(const PyDrawing& self) {
  const DrawingStats& s = self.drawing.stats;
  py::dict d;
  d["triangles"] = s.triangles;
  d["strokes"] = s.strokes;
  d["coverage_points"] = s.coverage_points;
  d["coverage_delta"] = s.coverage_delta;
  if (s.tone_gamma) d["tone_gamma"] = *s.tone_gamma;
  if (s.verify) d["verify"] = verification(*s.verify);
  return d;
}

}  // namespace

py::list to_list(const std::vector<DrawingItem>& items) {
  py::list list;
  for (const DrawingItem& item : items) {
    py::dict d;
    d["number"] = item.number;
    d["name"] = item.name;
    d["quantity"] = item.quantity();
    d["color"] = item.color;
    d["source"] = item.source;
    d["parts"] = item.parts;
    d["selectors"] = item.selectors;
    list.append(d);
  }
  return list;
}

namespace {

py::list views(const PyDrawing& self) {
  py::list list;
  for (const SheetView& view : self.drawing.views) {
    py::dict d;
    d["name"] = view.name;
    d["view"] = PyView{view.view};
    d["box"] = py::make_tuple(view.box.min.x, view.box.min.y, view.box.max.x, view.box.max.y);
    list.append(d);
  }
  return list;
}

}  // namespace

void add_drawing(py::module_& module) {
  add_lines(module);
  py::class_<PyDrawing, DrawingOwner> drawing(module, "Drawing", "A sheet of lines, in mm.");
  of_package(drawing)
      .def_property_readonly(
          "layers",
          [](const DrawingOwner& self) {
            py::list list;
            for (std::size_t i = 0; i < self->drawing.layers.size(); ++i) {
              list.append(py::cast(PyLayer{self, i}));
            }
            return list;
          },
          "The layers, painted in order.")
      .def_property_readonly(
          "diagnostics", [](const PyDrawing& self) { return to_list(self.drawing.diagnostics); },
          "What was mended, degraded or left out.")
      .def_property_readonly("parts", parts,
                             "A dict a part: id, name, source, triangles, faces, assembly, color.")
      .def_property_readonly(
          "items", [](const PyDrawing& self) { return to_list(self.drawing.items); },
          "A dict an item, by number, where callouts, a parts list or a legend were asked "
          "for: number, name, quantity, color, source, parts (their ids).")
      .def_property_readonly(
          "view", [](const PyDrawing& self) { return PyView{self.drawing.view}; },
          "How the sheet was seen.")
      .def_property_readonly("views", views,
                             "A dict a view, where the sheet has several: name, view, box (left, "
                             "bottom, right, top in mm).")
      .def_property_readonly(
          "paper",
          [](const PyDrawing& self) {
            return py::make_tuple(self.drawing.paper_width, self.drawing.paper_height);
          },
          "Width and height of the sheet in mm.")
      .def_property_readonly(
          "style", [](const PyDrawing& self) { return self.drawing.style; }, "Name of the style.")
      .def_property_readonly(
          "seed", [](const PyDrawing& self) { return self.drawing.seed; }, "The random seed.")
      .def_property_readonly(
          "stats", stats,
          "triangles, strokes, coverage_points, coverage_delta (mm of paper); tone_gamma, "
          "where the style balances its tone.")
      .def_property_readonly(
          "areas", [](const PyDrawing& self) { return area_dicts(self.drawing); },
          "A dict an area under the lines, in the order of painting: part (-1: the shadow on the "
          "ground), face, tone (from 0, the darkest; -1: any), fill (\"#rrggbb\" or \"\"), "
          "opacity, ink (spot ink, or \"\"), tint (its share), role (\"legend\": a square of it), "
          "rings (arrays (N, 2) in mm: inside an odd number of them), polygons (the same rings as "
          "tuples (shell, [hole, ...]), as shapely.MultiPolygon takes them).")
      .def(
          "arrays", [](const PyDrawing& self) { return flat_arrays(self.drawing); },
          "All paths as few arrays: \"points\" (N, 2) and \"points3\" (N, 3) in mm, \"width\" (N,) "
          "in "
          "mm; and a path: \"first\" (P + 1,) index of its first point, \"layer\", \"kind\", "
          "\"part\", \"face\", \"edge\", \"family\", \"stroke_kind\", \"visible\", \"closed\" "
          "(P,); "
          "\"kinds\" and \"layers\" are lists of names.")
      .def(
          "save", save, py::arg("path"),
          "Writes a file whole or not at all; the suffix names the format. `options`: the format's "
          "keys with underscores, e.g. svg_flatten=True. Throws OutputError.")
      .def("to_bytes", to_bytes, py::arg("format"),
           "The file of that format (\"svg\", \"json\" ...) in memory.")
      .def_static("load", load, py::arg("path"),
                  "A drawing file (JSON), of Burin or of another program. Throws InputError.")
      .def_static("from_json", from_json, py::arg("text"),
                  "The same for text in memory, str or bytes. Throws InputError with the line.")
      .def(py::pickle([](const DrawingOwner& self) { return to_bytes(self, "json", {}); },
                      [](const py::bytes& text) { return from_json(text); }))
      .def(
          "_repr_svg_", [](const DrawingOwner& self) { return py::str(to_bytes(self, "svg", {})); },
          "What Jupyter shows.")
      .def("__repr__", [](const PyDrawing& self) {
        std::size_t paths = 0;
        for (const Layer& layer : self.drawing.layers) paths += layer.paths.size();
        return fmt::format("<burin.Drawing {:g} x {:g} mm, {} paths>", self.drawing.paper_width,
                           self.drawing.paper_height, paths);
      });
}

}  // namespace burin::python
