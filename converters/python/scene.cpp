#include "scene.h"

#include <burin/base/error.h>
#include <burin/converters/messages.h>
#include <burin/converters/read.h>
#include <burin/converters/request.h>
#include <burin/drawing/color.h>

#include "add_parts.h"
#include "arrays.h"
#include "module.h"
#include "pmi.h"
#include "read.h"
#include "run.h"
#include "style_text.h"
#include "text.h"
#include "threads.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace burin::python {
namespace {

using Owner = std::shared_ptr<PyScene>;

/// "#rrggbb" of a colour or its name, or empty. Throws UsageError.
std::string color_of(const std::string& text) {
  std::string color = without_name(text);
  if (color.empty() || rgb_of(color)) return color;
  throw UsageError(
      fmt::format("the color of a part is \"#rrggbb\", one of the names {}, or empty, not '{}'",
                  said_color_names(), text));
}

PyPart append(const Owner& owner, Part part, const PartNames& names) {
  part.name = names.name;
  part.color = color_of(names.color);
  if (py::isinstance<py::str>(names.assembly)) {
    throw py::type_error("argument assembly takes a list of names");
  }
  for (const py::handle name : names.assembly) part.assembly.push_back(name.cast<std::string>());
  part.source = names.source;
  owner->scene.parts.push_back(std::move(part));
  owner->part_styles.resize(owner->scene.parts.size());
  return {owner, owner->scene.parts.size() - 1};
}

/// pybind11 2.10 takes no keywords of their own after *args.
Owner read(const py::args& paths, const py::kwargs& keywords) {
  const auto pop = [&](const char* name) -> py::object {
    if (!keywords.contains(name)) return py::none();
    return keywords.attr("pop")(name);
  };
  std::vector<std::string> names;
  for (const py::handle path : paths) names.push_back(path_text(path));
  if (names.empty()) throw UsageError("no input; name model files");
  const py::object progress = pop("progress"), cancel = pop("cancel");
  const auto flag = cancel_flag(cancel);
  const ReadOptions read = read_options(keywords, {"progress", "cancel"});
  auto owner = std::make_shared<PyScene>();
  run(progress, flag, [&](RunContext& context) {
    check_inputs(names);
    ReadResult files = read_files(names, read, context);
    owner->scene = std::move(files.scene);
    owner->marks = std::move(files.marks);
    owner->part_styles.resize(owner->scene.parts.size());
  });
  return owner;
}

/// The signature stands in the text, for pybind11 does not know it.
void add_read(py::class_<PyScene, Owner>& scene) {
  py::options options;
  options.disable_function_signatures();
  scene.def_static(
      "read", read,
      "read(*paths: object, progress: object = None, "
      "cancel: burin.Cancel = None, **options) -> burin.Scene\n\n"
      "Files, by their formats, as parts in order. `options` are the long options of the command "
      "line that concern reading, with underscores. Throws InputError.\n");
}

py::array box_array(const Box3& b) {
  if (b.empty()) throw GeometryError("the scene has no parts, and so no bounds");
  return own<double>({b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z}, {2, 3});
}

template <class T>
void property(py::class_<PyPart>& c, const char* name, T Part::*member, const char* doc) {
  c.def_property(
      name, [member](const PyPart& p) { return p.part().*member; },
      [member](const PyPart& p, const T& value) { p.part().*member = value; }, doc);
}

void look(py::class_<PyPart>& c, const char* name, bool PartStyle::*member, const char* doc) {
  c.def_property(
      name, [member](const PyPart& p) { return p.look().*member; },
      [member](const PyPart& p, bool value) { p.look().*member = value; }, doc);
}

py::object style_dict(const std::optional<Style>& style) {
  return style ? py::object(flat(*style)) : py::none();
}

void add_part(py::module_& module) {
  py::class_<PyPart> part(module, "Part", "One part of a scene.");
  of_package(part);
  property(part, "name", &Part::name, "Its name on the drawing.");
  property(part, "source", &Part::source, "The file it came from, as the user named it.");
  part.def_property(
      "color", [](const PyPart& p) { return p.part().color; },
      [](const PyPart& p, const std::string& value) {
        p.part().color = color_of(value);
        p.part().face_colors = nullptr;
      },
      "\"#rrggbb\", or empty where it has none. It may be set by a name such as \"orange\"; faces "
      "with colours of their own then lose these.");
  property(part, "assembly", &Part::assembly,
           "Names from the top of an assembly down to what contains the part.");
  property(part, "definition", &Part::definition,
           "The name of what it is an instance of, by which parts lists call it; may be empty.");
  part.def_property(
      "opacity", [](const PyPart& p) { return p.part().opacity; },
      [](const PyPart& p, double value) {
        if (!(value >= 0 && value <= 1)) {
          throw UsageError(fmt::format("the opacity of a part is 0 to 1, not {}", value));
        }
        p.part().opacity = value;
      },
      "How much of what lies behind it the part covers: 1 all of it, 0 nothing. Below 1 it is "
      "drawn as transparent.");
  property(part, "joined", &Part::joined,
           "Whether it is one thing with the part before it and differs by its look alone, such as "
           "what a module of OpenSCAD makes in a second colour: parts lists count them once, and "
           "exploded views do not take them apart.");
  part.def_property(
      "threads", [](const PyPart& p) { return list_of(p.part().threads); },
      [](const PyPart& p, const py::sequence& value) { p.part().threads = threads_of(value); },
      "Threads that its form does not have, a mapping each: \"size\" (\"M6\", \"1/4 UNC\"), "
      "\"at\" (where it begins on its axis), \"along\" (which way it goes), \"length\" in mm, "
      "\"internal\" (default True: in a hole). They are drawn on the cylinder about this axis.");
  look(part, "drawn", &PartStyle::drawn, "False: as if the part were not there.");
  look(part, "hatched", &PartStyle::hatched, "False: lines alone, without strokes.");
  look(part, "transparent", &PartStyle::transparent,
       "Its lines are drawn, without strokes, and it hides itself but no other part.");
  look(part, "listed", &PartStyle::listed,
       "False: it is drawn, but is no item of a parts list and has no callout.");
  part.def_property(
      "style", [](const PyPart& p) { return style_dict(p.look().style); },
      [](const PyPart& p, const py::object& value) {
        p.look().style = value.is_none() ? std::nullopt : std::optional(style_of(value));
      },
      "A style of its own, as `style` of `draw` takes it; None = that of the drawing.");
  part.def("__repr__", [](const PyPart& p) { return "<burin.Part '" + p.part().name + "'>"; });
}

void add_diagnostic(py::module_& module) {
  py::class_<Diagnostic> diagnostic(module, "Diagnostic",
                                    "What was mended, degraded or left out, and how often.");
  of_package(diagnostic)
      .def_property_readonly(
          "severity", [](const Diagnostic& d) { return to_string(d.severity); },
          "\"info\", \"warning\" or \"error\".")
      .def_readonly("code", &Diagnostic::code, "Stable, e.g. \"mesh.nonmanifold_edges\".")
      .def_readonly("count", &Diagnostic::count, "How often it occurred.")
      .def_readonly("message", &Diagnostic::message, "One sentence.")
      .def("__repr__", [](const Diagnostic& d) {
        return std::string("<burin.Diagnostic ") + to_string(d.severity) + " " + d.code + ": " +
               d.message + ">";
      });
}

/// "<burin.Scene of 3 parts: 'base', 'lid', 'pin'>", the names of the first few.
std::string repr(const PyScene& self) {
  constexpr std::size_t kNamed = 4;
  const auto& parts = self.scene.parts;
  std::string text =
      fmt::format("<burin.Scene of {} part{}", parts.size(), parts.size() == 1 ? "" : "s");
  for (std::size_t i = 0; i < std::min(parts.size(), kNamed); ++i) {
    text +=
        fmt::format("{}{}", i == 0 ? ": " : ", ", std::string(py::repr(py::str(parts[i].name))));
  }
  return text + (parts.size() > kNamed ? ", ...>" : ">");
}

}  // namespace

py::list to_list(const Diagnostics& diagnostics) {
  py::list list;
  for (const Diagnostic& d : diagnostics.entries()) list.append(py::cast(d));
  return list;
}

void add_brep(py::module_& module) {
  py::class_<PyBrep> brep(
      module, "Brep",
      "A shape as OCCT writes it in text or binary (FreeCAD: "
      "shape.exportBrepToString()), read once: the parts that are made of it share it.");
  of_package(brep)
      .def(py::init(&read_brep), py::arg("brep"), "Throws InputError, GeometryError.")
      .def("is_valid", &is_valid,
           "Whether OCCT finds nothing wrong with it. Slow: for messages about what cannot be "
           "drawn.")
      .def("__repr__", [](const PyBrep&) { return "<burin.Brep>"; });
}

void add_scene(py::module_& module) {
  add_diagnostic(module);
  add_part(module);
  add_brep(module);
  py::class_<PyScene, Owner> scene(module, "Scene", "What is drawn: parts in order.");
  add_read(of_package(scene));
  scene.def(py::init<>())
      .def(
          "add_brep",
          [](const Owner& self, const py::object& brep, const std::string& name,
             const py::object& placement, const std::string& color, const py::object& assembly,
             const std::string& source, std::vector<std::string> face_colors) {
            Part part = brep_part(brep, placement, color_of(color), std::move(face_colors));
            const std::string of_part = part.color;
            return append(self, std::move(part), {name, of_part, assembly, source});
          },
          py::arg("brep"), py::arg("name") = "", py::kw_only(), py::arg("placement") = py::none(),
          py::arg("color") = "", py::arg("assembly") = py::tuple(), py::arg("source") = "",
          py::arg("face_colors") = py::tuple(),
          "A shape as OCCT writes it in text or binary (FreeCAD: shape.exportBrepToString()), or a "
          "Brep. "
          "`placement` is a 4 x 4 affine matrix (row major, acts on columns): it may turn, mirror, "
          "stretch and shear, and not flatten. One part, "
          "whatever its solids; faces and edges are numbered as in the shape (TopExp order), from "
          "0. `face_colors`: a colour for each face, where they have several, of glass "
          "\"#rrggbbaa\" "
          "with its opacity; an empty one is `color`, and the part then has the colour of most of "
          "its area.")
      .def(
          "add_mesh",
          [](const Owner& self, const py::object& vertices, const py::object& triangles,
             const std::string& name, const std::string& color, const py::object& assembly,
             const std::string& source, const py::object& texture) {
            Diagnostics found;
            Part part = mesh_part(vertices, triangles, texture, name, found);
            self->scene.diagnostics.append(found);
            return append(self, std::move(part), {name, color, assembly, source});
          },
          py::arg("vertices"), py::arg("triangles"), py::arg("name") = "", py::kw_only(),
          py::arg("color") = "", py::arg("assembly") = py::tuple(), py::arg("source") = "",
          py::arg("texture") = py::none(),
          "`vertices` (n, 3) in mm, `triangles` (m, 3) of any integer type, counter-clockwise seen "
          "from outside; repaired as files are (see `diagnostics`). `texture` (n, 2): u and "
          "v of the vertices, for laws and pictures.")
      .def(
          "add_function",
          [](const Owner& self, const py::object& values, const py::object& bounds,
             const std::string& name, const py::object& gradients, const py::object& hessians,
             const py::object& samples) {
            return append(self, function_part({values, gradients, hessians}, bounds, samples),
                          {name, "", py::tuple(), ""});
          },
          py::arg("values"), py::arg("bounds"), py::arg("name") = "", py::kw_only(),
          py::arg("gradients") = py::none(), py::arg("hessians") = py::none(),
          py::arg("samples") = 192,
          "The zero set of a function, negative inside, clipped by `bounds` (x0, y0, z0, x1, y1, "
          "z1): "
          "`values` takes points (n, 3) in mm and gives (n,). It is called for a grid with "
          "`samples` "
          "points along the longest side of the bounds, and what is drawn is the cubic spline "
          "through "
          "them. samples=0 calls the function for every point of the surface that is wanted, which "
          "takes minutes; then `gradients` gives (n, 3) and `hessians` (n, 3, 3), both by central "
          "differences where absent. Called with the GIL, by threads that wait in this module.")
      .def(
          "add_implicit",
          [](const Owner& self, const std::string& text, const std::string& name,
             const py::object& bounds) {
            return append(self, implicit_part(text, bounds), {name, "", py::tuple(), ""});
          },
          py::arg("text"), py::arg("name") = "", py::kw_only(), py::arg("bounds") = py::none(),
          "A function as text, as in `.implicit` files. Throws InputError with the line.")
      .def_property_readonly(
          "parts",
          [](const Owner& self) {
            py::list list;
            for (std::size_t i = 0; i < self->scene.parts.size(); ++i) {
              list.append(py::cast(PyPart{self, i}));
            }
            return list;
          },
          "The parts, in the order of the drawing's part numbers.")
      .def(
          "bounds", [](const PyScene& self) { return box_array(self.scene.bounds()); },
          "(2, 3) in mm: least and greatest coordinates.")
      .def_property_readonly(
          "pmi", [](const PyScene& self) { return pmi_of(self.scene); },
          "The dimensions, tolerances, datums and notes of STEP files that were read with "
          "pmi=True: "
          "a dict each, as `burin info --json` has it, with its `part`, and how the file shows it: "
          "`lines` and `filled`, arrays (n, 3) in mm.")
      .def_property_readonly(
          "diagnostics",
          [](const PyScene& self) {
            return to_list(with_spelling(self.scene.diagnostics, Spelling::Keywords));
          },
          "What the readers mended or left out.")
      .def("__len__", [](const PyScene& self) { return self.scene.parts.size(); })
      .def("__repr__", repr);
}

}  // namespace burin::python
