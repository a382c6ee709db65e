#include "illustration.h"

#include <burin/assembly/select.h>
#include <burin/converters/illustration.h>
#include <burin/converters/request.h>

#include "module.h"
#include "style_text.h"
#include "text.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace burin::python {
namespace {

py::list list_of(Vec3 v) {
  py::list list;
  for (int k = 0; k < 3; ++k) list.append(v[k]);
  return list;
}

/// Rows that act on columns, as `placement` of `Scene.add_brep`.
py::list matrix_of(const Placement& place) {
  py::list rows;
  for (int row = 0; row < 3; ++row) {
    py::list numbers;
    for (int column = 0; column < 3; ++column) numbers.append(place.linear[column][row]);
    numbers.append(place.offset[row]);
    rows.append(numbers);
  }
  rows.append(py::cast(std::vector<double>{0, 0, 0, 1}));
  return rows;
}

py::dict dict_of(const IllustrationInput& input) {
  py::dict out;
  out["file"] = input.file;
  out["function"] = input.function;
  out["name"] = input.name;
  out["place"] = matrix_of(input.place);
  py::list read;
  for (const auto& [option, texts] : input.read) read.append(option);
  out["read"] = read;
  return out;
}

py::dict dict_of(const tone::Light& light) {
  py::dict out;
  if (light.kind == tone::Light::Kind::Ambient) {
    out["ambient"] = light.strength;
    return out;
  }
  out[light.kind == tone::Light::Kind::From ? "from" : "at"] = list_of(light.place);
  out["strength"] = light.strength;
  return out;
}

/// A name or a file where it has one, else all keys.
py::object style_as_object(const std::string& named, const std::optional<Style>& style) {
  if (!named.empty()) return py::str(named);
  return style ? py::object(flat(*style)) : py::none();
}

py::dict dict_of(const Look& look, const std::string& style_named) {
  py::dict out;
  out["select"] = look.select;
  out["drawn"] = look.drawn;
  out["hatched"] = look.hatched;
  out["transparent"] = look.transparent;
  out["listed"] = look.listed;
  out["style"] = style_as_object(style_named, look.style);
  return out;
}

py::dict view_of(const DrawPlan& plan) {
  const ViewOptions& view = plan.view;
  py::dict out;
  out["from"] = list_of(view.direction);
  out["up"] = list_of(view.up);
  out["perspective"] = view.perspective;
  out["scale"] = plan.sheet.iso_scale ? py::object(py::str("iso")) : py::cast(view.scale);
  out["center"] = view.center ? py::object(list_of(*view.center)) : py::none();
  return out;
}

py::dict paper_of(const DrawPlan& plan) {
  py::dict out;
  const Margin& m = plan.sheet.margin;
  const Paper& paper = plan.view.paper;
  out["size"] = plan.sheet.fits ? py::object(py::str("fit"))
                                : py::object(py::make_tuple(paper.width, paper.height));
  out["margin"] = py::make_tuple(m.top, m.right, m.bottom, m.left);
  return out;
}

template <class List>
py::list list_of_dicts(const List& list) {
  py::list out;
  for (const auto& one : list) out.append(dict_of(one));
  return out;
}

/// A mapping as JSON.
std::string json_of(const py::object& mapping) {
  return py::module_::import("json").attr("dumps")(mapping).cast<std::string>();
}

IllustrationFile illustration_of(const py::object& source, std::string* members) {
  if (!is_mapping(source)) return read_illustration(path_text(source), members);
  return parse_illustration(json_of(source), "illustration", members);
}

/// What stands there, one or a list, as a list.
py::list list_at(const py::dict& members, const char* name) {
  if (!members.contains(name)) return py::list();
  const py::object value = members[name];
  if (py::isinstance<py::list>(value)) return value.cast<py::list>();
  py::list list;
  list.append(value);
  return list;
}

py::dict illustration(const py::object& source) {
  std::string as_json;
  const IllustrationFile file = illustration_of(source, &as_json);
  const auto members = py::module_::import("json").attr("loads")(as_json).cast<py::dict>();
  const DrawPlan plan = make_plan(file.request, Spelling::Keywords);
  const auto named = given_texts(file.request.options, "style");
  py::dict out;
  out["title"] = file.request.title;
  out["parts"] = list_of_dicts(file.inputs);
  out["view"] = view_of(plan);
  out["paper"] = paper_of(plan);
  out["lights"] = list_of_dicts(file.request.lights);
  out["light"] = list_of(plan.style.tone.light);
  out["style"] = style_as_object(named.empty() ? "" : named.back(), plan.style);
  out["looks"] = py::list();
  for (std::size_t i = 0; i < plan.looks.size(); ++i) {
    out["looks"].attr("append")(dict_of(plan.looks[i], file.request.looks[i].style));
  }
  out["sections"] = list_at(members, "section");
  out["explode"] = plan.explode.wanted ? py::object(members["explode"]) : py::none();
  out["views"] = plan.views;
  out["hidden_views"] = plan.hidden_views;
  out["projection"] = plan.projection == ProjectionMethod::FirstAngle ? "first" : "third";
  out["breaks"] = list_at(members, "breaks");
  out["details"] = list_at(members, "details");
  out["threads"] = list_at(members, "threads");
  out["dimensions"] = list_at(members, "dimensions");
  out["notes"] = list_at(members, "notes");
  out["arrows"] = list_at(members, "arrows");
  py::dict items;
  for (const auto& [number, item] : plan.numbers) items[py::int_(number)] = item.name;
  out["items"] = items;
  out["callouts"] = plan.callouts;
  out["parts_list"] = plan.parts_list;
  out["legend"] = plan.legend;
  out["title_block"] = plan.title_block && members.contains("title_block")
                           ? py::object(members["title_block"])
                           : py::none();
  out["hidden"] = plan.illustrate.hidden == HiddenLines::Dashed ? "dashed" : "none";
  out["tolerance"] = plan.illustrate.tolerance;
  out["seed"] = plan.illustrate.seed;
  return out;
}

/// Text of a mapping; empty where it has no such key.
std::string text_at(const py::handle& mapping, const char* key) {
  const py::object value = mapping.attr("get")(key, "");
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  throw py::type_error(
      fmt::format("argument parts: \"{}\" is text, not {}", key, std::string(py::repr(value))));
}

Part part_named(const py::handle& mapping) {
  if (!is_mapping(mapping)) {
    throw py::type_error(
        fmt::format("argument parts takes mappings, not {}", std::string(py::repr(mapping))));
  }
  Part part;
  part.name = text_at(mapping, "name");
  part.color = text_at(mapping, "color");
  part.source = text_at(mapping, "source");
  for (const py::handle name : mapping.attr("get")("assembly", py::tuple())) {
    part.assembly.push_back(py::str(name).cast<std::string>());
  }
  return part;
}

std::vector<std::size_t> selected(const py::iterable& parts, const std::string& selector) {
  Scene names;
  for (const py::handle part : parts) names.parts.push_back(part_named(part));
  return select(names, selector);
}

}  // namespace

IllustrationFile illustration_of(const py::object& source) {
  return illustration_of(source, nullptr);
}

DrawRequest settings_of(const py::object& mapping) {
  if (!is_mapping(mapping)) {
    throw py::type_error(fmt::format("argument illustration takes a mapping, not {}",
                                     std::string(py::repr(mapping))));
  }
  py::dict whole;
  whole["burin"] = "illustration";
  whole.attr("update")(mapping);
  return parse_settings(json_of(whole), "illustration");
}

void add_illustration(py::module_& module) {
  module.def("illustration_schema", illustration_schema,
             "The JSON Schema of illustration files, as text.");
  module.def(
      "illustration", illustration, py::arg("source"),
      "The values of an illustration, a file NAME.burin.json or a mapping of its keys, checked and "
      "with "
      "what it extends, without reading its models: \"title\"; \"parts\" (\"file\" as found from "
      "here, \"function\", \"name\", \"place\" as 4 rows, \"read\": options about reading); "
      "\"view\" "
      "(\"from\" and \"up\" as directions, \"perspective\" in degrees, \"scale\" as a number or "
      "\"iso\", \"center\" in "
      "mm); \"paper\" (\"size\" in mm or \"fit\", \"margin\": top, right, bottom, left); "
      "\"lights\" unchanged; \"light\"; \"style\": a name or file, or all its keys; "
      "\"looks\"; \"sections\", \"explode\", \"breaks\", \"details\", \"threads\", "
      "\"dimensions\", \"notes\" and \"arrows\" unchanged; "
      "\"views\", "
      "names, and "
      "\"projection\"; \"items\", number to name; \"title_block\" unchanged; "
      "\"callouts\", \"parts_list\" and \"legend\" (on the sheet), True or False; \"hidden\", "
      "\"tolerance\" in "
      "mm, \"seed\". A key that is not "
      "given has the default of `draw`, or None. Throws UsageError, InputError.");
  module.def(
      "select", selected, py::arg("parts"), py::arg("selector"),
      "Numbers of the parts that a selector names, ascending. `parts`: mappings with \"name\" and, "
      "where they have it, \"assembly\", \"color\", \"source\", as `Drawing.parts`. Throws "
      "UsageError with the nearest names if it names nothing.");
}

}  // namespace burin::python
