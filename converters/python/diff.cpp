#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/diff.h>
#include <burin/converters/output.h>
#include <burin/converters/read_drawing.h>
#include <burin/illustrate/style.h>

#include "call.h"
#include "drawing.h"
#include "module.h"
#include "run.h"
#include "scene.h"
#include "text.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace burin::python {
namespace {

struct PyDifference {
  DiffOutcome outcome;
  DrawingOwner drawing;

  WriteOptions options() const {
    WriteOptions options = write_options(drawing->style);
    options.svg.id_prefix = drawing->id_prefix;
    return options;
  }
};

/// What a source is called in titles.
std::string name_of(const py::object& source, const char* otherwise) {
  if (py::isinstance<py::str>(source) || py::hasattr(source, "__fspath__")) {
    return std::filesystem::path(path_text(source)).filename().string();
  }
  return otherwise;
}

bool is_path(const py::object& source) {
  return py::isinstance<py::str>(source) || py::hasattr(source, "__fspath__");
}

bool is_drawing(const py::object& source) {
  return py::isinstance<PyDrawing>(source) ||
         (is_path(source) && is_drawing_file(path_text(source)));
}

Drawing drawing_of(const py::object& source) {
  if (py::isinstance<PyDrawing>(source)) return source.cast<const PyDrawing&>().drawing;
  const std::string name = path_text(source);
  Drawing drawing;
  run(py::none(), nullptr, [&](RunContext& context) { drawing = read_drawing(name, context); });
  return drawing;
}

void keep(DiffOutcome outcome, const Style& style, const std::string& id_prefix,
          PyDifference& difference) {
  difference.drawing = std::make_shared<PyDrawing>(PyDrawing{*outcome.drawing, style, id_prefix});
  difference.outcome = std::move(outcome);
}

PyDifference diff_of_drawings(const py::object& before, const py::object& after, double tolerance,
                              const py::kwargs& keywords) {
  if (!keywords.empty()) {
    throw UsageError(
        "two drawings are compared line by line; of the arguments only "
        "line_tolerance is about them");
  }
  if (!(tolerance >= 0.001 && tolerance <= 100)) {
    throw UsageError("argument line_tolerance takes 0.001 to 100 mm");
  }
  const Drawing was = drawing_of(before), is = drawing_of(after);
  const std::string old_name = name_of(before, "old"), new_name = name_of(after, "new");
  DiffOutcome outcome;
  run(py::none(), nullptr, [&](RunContext& context) {
    outcome = diff_drawings(was, is, old_name, new_name, tolerance, true, context);
  });
  PyDifference difference;
  keep(std::move(outcome), builtin_style("technical"), {}, difference);
  return difference;
}

PyDifference diff(const py::object& before, const py::object& after, double line_tolerance,
                  const py::kwargs& keywords) {
  const bool first = is_drawing(before), second = is_drawing(after);
  if (first != second) {
    throw UsageError("compare a drawing with a drawing, a model with a model");
  }
  if (first) return diff_of_drawings(before, after, line_tolerance, keywords);
  for (const char* name :
       {"session", "explode", "explode_factor", "callouts", "parts_list", "legend", "verify"}) {
    if (keywords.contains(name) && !keywords[name].is_none()) {
      throw UsageError(std::string("argument ") + name + " is not for two revisions");
    }
  }
  Call old_call(before, keywords), new_call(after, keywords);
  const std::string old_name = name_of(before, "old"), new_name = name_of(after, "new");
  DiffOutcome outcome;
  run(new_call.with.progress, cancel_flag(new_call.with.cancel), [&](RunContext& context) {
    const ThreadLimit limit(new_call.plan().threads);
    Revision was = read_revision(old_call.task, old_name, context);
    Revision is = read_revision(new_call.task, new_name, context);
    outcome = diff_models(std::move(was), std::move(is), true, context);
  });
  PyDifference difference;
  keep(std::move(outcome), new_call.plan().style, new_call.plan().id_prefix, difference);
  return difference;
}

py::object parsed(const PyDifference& self) {
  return py::module_::import("json").attr("loads")(difference_json(self.outcome));
}

/// A member of the report; an empty list where it has none.
py::object member(const PyDifference& self, const char* name) {
  return parsed(self).attr("get")(name, py::list());
}

void save(const PyDifference& self, const py::args& paths) {
  std::vector<std::string> names;
  for (const py::handle path : paths) names.push_back(path_text(path));
  if (names.empty()) throw UsageError("no file; name one: save(\"diff.svg\")");
  run(py::none(), nullptr, [&](RunContext& context) {
    std::vector<Output> files = plan_outputs(names, "", {});
    for (Output& file : files) {
      file.write([&](std::ostream& out) {
        write_difference(self.outcome, file.name(), file.format(), self.options(), out, context);
      });
    }
    context.check();
    for (Output& file : files) file.commit();
  });
}

}  // namespace

void add_diff(py::module_& module) {
  py::class_<PyDifference> difference(module, "Difference",
                                      "What has changed between two revisions.");
  of_package(difference)
      .def_property_readonly(
          "same", [](const PyDifference& self) { return self.outcome.same; },
          "Whether nothing has changed.")
      .def_property_readonly(
          "parts", [](const PyDifference& self) { return member(self, "parts"); },
          "Of models: a dict a part, as the report for programs has it (kernel/docs/changes.md).")
      .def_property_readonly(
          "lines", [](const PyDifference& self) { return member(self, "lines"); },
          "Of drawings: a dict a line that is not the same.")
      .def_property_readonly(
          "counts", [](const PyDifference& self) { return member(self, "counts"); },
          "How many there are of each kind of change.")
      .def_property_readonly(
          "drawing", [](const PyDifference& self) { return self.drawing; },
          "Both revisions in one drawing.")
      .def_property_readonly(
          "diagnostics", [](const PyDifference& self) { return to_list(self.outcome.diagnostics); },
          "What could not be compared, and what was mended or left out as files were read.")
      .def(
          "to_json", [](const PyDifference& self) { return difference_json(self.outcome); },
          "The report for programs.")
      .def("save", save,
           "Writes files, all of them or none: NAME.json is the report for programs, NAME.html a "
           "page of drawing and table, any other suffix and NAME.drawing.json the drawing. Throws "
           "OutputError, UsageError.")
      .def("__str__", [](const PyDifference& self) { return difference_text(self.outcome); })
      .def("__repr__", [](const PyDifference& self) {
        return "<burin.Difference " + self.outcome.counts + ">";
      });
  module.def(
      "diff", diff, py::arg("old"), py::arg("new"), py::kw_only(),
      py::arg("line_tolerance") = kLineTolerance,
      "Compares two revisions of a model, part by part, and draws both: files, scenes or "
      "illustrations as `draw` takes them; or two drawings, line by line within "
      "`line_tolerance` mm of paper. Keywords are those of `draw`, but for session, explode, "
      "callouts, parts_list, legend and verify. Throws Error.");
}

}  // namespace burin::python
