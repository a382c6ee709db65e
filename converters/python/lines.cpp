#include "lines.h"

#include "arrays.h"
#include "flat_arrays.h"
#include "module.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <utility>

namespace burin::python {
namespace {

py::list texts(const PyLayer& self) {
  py::list list;
  for (const Text& text : self.layer().texts) {
    py::dict d;
    d["text"] = text.text;
    d["at"] = py::make_tuple(text.at.x, text.at.y);
    d["height"] = text.height;
    d["anchor"] = to_string(text.anchor);
    d["role"] = text.role;
    d["item"] = text.item;
    d["turn"] = text.turn;
    list.append(d);
  }
  return list;
}

py::ssize_t rows(std::size_t n) { return static_cast<py::ssize_t>(n); }

py::array project(const PyView& self, const py::object& model) {
  const DrawingView& v = self.view;
  const std::vector<Vec3> from = points(model, "points");
  // From the plane through the centre to the viewer; none in an orthographic view.
  const double eye = v.projection == "perspective" ? glm::dot(v.eye - v.center, v.direction) : 0;
  std::vector<double> out;
  out.reserve(2 * from.size());
  for (const Vec3& p : from) {
    const Vec3 q = p - v.center;
    const double s = eye > 0 ? v.scale * eye / (eye - glm::dot(q, v.direction)) : v.scale;
    const Vec2 whole = Vec2(s * glm::dot(q, v.right), s * glm::dot(q, v.up)) + v.offset;
    const Vec2 at = v.breaks.moved(whole);
    out.insert(out.end(), {at.x, at.y});
  }
  return own(std::move(out), {rows(from.size()), 2});
}

void add_path(py::module_& module) {
  py::class_<PyPath> path(module, "Path", "One line of the drawing.");
  of_package(path)
      .def_property_readonly(
          "kind", [](const PyPath& p) { return to_string(p.path().kind); },
          "contour, boundary, crease, smooth, seam, intersection, stroke ...")
      .def_property_readonly(
          "visible", [](const PyPath& p) { return p.path().visible; }, "False where it is dashed.")
      .def_property_readonly(
          "part", [](const PyPath& p) { return p.path().source.part; }, "Number of the part.")
      .def_property_readonly(
          "face", [](const PyPath& p) { return p.path().source.face; },
          "Number of the face in the part, -1 = none.")
      .def_property_readonly(
          "edge", [](const PyPath& p) { return p.path().source.edge; },
          "Number of the edge in the part, -1 = none.")
      .def_property_readonly(
          "closed", [](const PyPath& p) { return p.path().closed; },
          "Whether the last point joins the first, which is not repeated.")
      .def_property_readonly(
          "field", [](const PyPath& p) { return p.path().field; },
          "Strokes: the direction field, else empty.")
      .def_property_readonly(
          "family", [](const PyPath& p) { return p.path().family; },
          "Strokes: 1 or 2, the family in the field, else 0.")
      .def_property_readonly(
          "item", [](const PyPath& p) { return p.path().item; },
          "Leaders and frames: the number of their item, else 0.")
      .def_property_readonly(
          "color", [](const PyPath& p) { return p.path().color; },
          "\"#rrggbb\"; empty: that of its layer.")
      .def_property_readonly(
          "stroke_kind", [](const PyPath& p) { return p.path().stroke_kind; },
          "Strokes: which of the style's kinds of strokes, from 1.")
      .def_property_readonly(
          "points",
          [](const PyPath& p) {
            const auto& v = p.path().points;
            return view(v.empty() ? nullptr : &v[0].x, {rows(v.size()), 2}, py::cast(p.owner));
          },
          "(n, 2) mm of paper; read-only, no copy.")
      .def_property_readonly(
          "points3",
          [](const PyPath& p) {
            const auto& v = p.path().points3;
            return view(v.empty() ? nullptr : &v[0].x, {rows(v.size()), 3}, py::cast(p.owner));
          },
          "(n, 3) mm of the model; read-only, no copy.")
      .def_property_readonly(
          "width",
          [](const PyPath& p) {
            const auto& v = p.path().width;
            return view(v.data(), {rows(v.size())}, py::cast(p.owner));
          },
          "(1,) or (n,) mm of paper; read-only, no copy.")
      .def("__len__", [](const PyPath& p) { return p.path().points.size(); })
      .def("__repr__", [](const PyPath& p) {
        return fmt::format("<burin.Path {}, {} points, part {}>", to_string(p.path().kind),
                           p.path().points.size(), p.path().source.part);
      });
}

void add_layer(py::module_& module) {
  py::class_<PyLayer> layer(module, "Layer", "Paths that are drawn together.");
  of_package(layer)
      .def_property_readonly(
          "name", [](const PyLayer& l) { return l.layer().name; }, "Its name in files.")
      .def_property_readonly(
          "paths",
          [](const PyLayer& l) {
            py::list list;
            for (std::size_t i = 0; i < l.layer().paths.size(); ++i) {
              list.append(py::cast(PyPath{l.owner, l.index, i}));
            }
            return list;
          },
          "The paths, in the order in which they are drawn.")
      .def_property_readonly(
          "color", [](const PyLayer& l) { return l.layer().color; },
          "\"#rrggbb\" of its lines and texts; empty: that of the drawing.")
      .def_property_readonly(
          "dashes", [](const PyLayer& l) { return l.layer().dashes; },
          "Lengths of dashes and gaps in turn, mm of paper; empty: as usual for its name.")
      .def_property_readonly("texts", texts,
                             "A dict a text over them: text, at (mm of the sheet, on the base "
                             "line), height (mm of capitals), anchor, role, item.")
      .def("__len__", [](const PyLayer& l) { return l.layer().paths.size(); })
      .def("__repr__", [](const PyLayer& l) {
        return fmt::format("<burin.Layer '{}', {} paths>", l.layer().name, l.layer().paths.size());
      });
}

void add_view(py::module_& module) {
  py::class_<PyView> view(module, "View",
                          "How the sheet was seen. `right`, `up` and `direction` are orthonormal.");
  of_package(view)
      .def_property_readonly(
          "projection", [](const PyView& v) { return v.view.projection; },
          "\"orthographic\" or \"perspective\".")
      .def_property_readonly(
          "direction", [](const PyView& v) { return to_array(v.view.direction); },
          "(3,) unit vector from the model to the viewer.")
      .def_property_readonly(
          "right", [](const PyView& v) { return to_array(v.view.right); },
          "(3,) what points right on the sheet.")
      .def_property_readonly(
          "up", [](const PyView& v) { return to_array(v.view.up); }, "(3,) what points up on it.")
      .def_property_readonly(
          "scale", [](const PyView& v) { return v.view.scale; },
          "Paper mm a model mm (perspective: in the plane through `center`).")
      .def_property_readonly(
          "center", [](const PyView& v) { return to_array(v.view.center); },
          "(3,) the model point at `offset`, in mm.")
      .def_property_readonly(
          "offset", [](const PyView& v) { return to_array(v.view.offset); }, "(2,) mm of paper.")
      .def_property_readonly(
          "eye", [](const PyView& v) { return to_array(v.view.eye); },
          "(3,) the viewer's place in mm; perspective only.")
      .def_property_readonly(
          "field_of_view", [](const PyView& v) { return v.view.field_of_view; },
          "Vertical, in degrees; 0 = orthographic.")
      .def("project", project, py::arg("points"),
           "(n, 3) mm of the model to (n, 2) mm of the sheet, of broken views, too.")
      .def("__repr__", [](const PyView& v) {
        const Vec3 d = v.view.direction;
        return fmt::format("<burin.View {} from ({:.4g}, {:.4g}, {:.4g}), scale {:.4g}>",
                           v.view.projection, d.x, d.y, d.z, v.view.scale);
      });
}

}  // namespace

void add_lines(py::module_& module) {
  add_path(module);
  add_layer(module);
  add_view(module);
}

}  // namespace burin::python
