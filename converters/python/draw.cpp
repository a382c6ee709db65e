#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/catalogues.h>
#include <burin/converters/messages.h>
#include <burin/converters/read.h>
#include <burin/converters/request.h>

#include "call.h"
#include "drawing.h"
#include "module.h"
#include "read.h"
#include "run.h"
#include "scene.h"
#include "text.h"

#include <pybind11/stl.h>

#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace burin::python {
namespace {

DrawingOwner draw(const py::object& source, const py::kwargs& keywords) {
  Call call(source, keywords);
  DrawPlan& plan = call.plan();
  PySession* const session = call.with.python_session();
  const auto flag = cancel_flag(call.with.cancel);
  auto result = std::make_shared<PyDrawing>();
  result->style = plan.style;
  result->id_prefix = plan.id_prefix;
  std::unique_lock<std::mutex> busy;
  if (session) {
    busy = std::unique_lock(session->busy, std::try_to_lock);
    if (!busy) throw UsageError("the session is drawing already; one drawing at a time");
  }
  run(call.with.progress, flag, [&](RunContext& context) {
    const ThreadLimit limit(plan.threads);
    Scene scene = call.read(context);
    arrange_parts(scene, plan, context);
    const SheetOfViews sheet = plan_sheet(scene, plan);
    result->drawing =
        burin::draw(scene, sheet, plan, context, session ? &session->session : nullptr);
    write_parts_lists(result->drawing, plan);
  });
  return result;
}

py::dict step_of(const Scene& scene, const ExplodeStep& step) {
  std::set<std::size_t> parts;
  for (const std::string& selector : step.move) {
    for (const std::size_t part : select(scene, selector)) parts.insert(part);
  }
  py::dict d;
  d["move"] = step.move;
  d["parts"] = std::vector<std::size_t>(parts.begin(), parts.end());
  d["along"] = py::make_tuple(step.along.x, step.along.y, step.along.z);
  d["by"] = step.by;
  d["trail"] = step.trail;
  return d;
}

py::dict explode_steps(const py::object& source, const py::kwargs& keywords) {
  Call call(source, keywords);
  DrawPlan& plan = call.plan();
  Scene scene;
  std::vector<ExplodeStep> steps;
  run(call.with.progress, cancel_flag(call.with.cancel), [&](RunContext& context) {
    const ThreadLimit limit(plan.threads);
    scene = call.read(context);
    select_parts(scene, plan);
    steps = burin::explode_steps(scene, plan, context);
  });
  py::list list;
  for (const ExplodeStep& step : steps) list.append(step_of(scene, step));
  py::dict found;
  found["steps"] = list;
  found["diagnostics"] = to_list(with_spelling(scene.diagnostics, Spelling::Keywords));
  return found;
}

py::list items(const py::object& source, const py::kwargs& keywords) {
  Call call(source, keywords);
  DrawPlan& plan = call.plan();
  plan.items = true;
  run(call.with.progress, cancel_flag(call.with.cancel), [&](RunContext& context) {
    const ThreadLimit limit(plan.threads);
    Scene scene = call.read(context);
    select_parts(scene, plan);
    number_parts(scene, plan, context);
  });
  return to_list(plan.illustrate.annotations->items);
}

py::list info(const py::args& paths, const py::kwargs& options) {
  std::vector<std::string> names;
  for (const py::handle path : paths) names.push_back(path_text(path));
  if (names.empty()) throw UsageError("no input; name model files");
  const ReadOptions read = read_options(options);
  std::vector<FileInfo> files;
  run(py::none(), nullptr, [&](RunContext& context) {
    check_inputs(names);
    context.begin_stage(RunStage::Read);
    for (const std::string& name : names) {
      files.push_back(inspect_file(name, read, context));
      files.back().diagnostics = with_spelling(files.back().diagnostics, Spelling::Keywords);
    }
    context.end_stage();
  });
  return py::module_::import("json").attr("loads")(to_json(files))["files"];
}

}  // namespace

void add_draw(py::module_& module) {
  py::class_<PySession> session(
      module, "Session",
      "Keeps what drawings of the same scene may use again: `draw(scene, session=session)` makes "
      "anew what light, style or view change, and draws the same. One drawing at a time.");
  of_package(session).def(py::init<>());
  module.def("draw", draw, py::arg("source"),
             "Called by burin.draw, which documents the arguments.");
  module.def(
      "explode_steps", explode_steps, py::arg("source"),
      "\"steps\", by which `draw` with the same arguments takes an assembly apart, found or as "
      "they were given, and \"diagnostics\" about them. A step is a dict: "
      "\"move\" (selectors), \"along\", \"by\" (mm) and \"trail\", as illustrations have it, and "
      "\"parts\", their numbers. Throws Error.");
  module.def("items", items, py::arg("source"),
             "The items of what `draw` with the same arguments draws, as in `Drawing.items`, "
             "numbered in the drawing or not. Throws Error.");
  module.def(
      "catalogues", [] { return py::module_::import("json").attr("loads")(catalogues_json()); },
      "All options and keys, as `burin options --json` lists them: \"options\" (of draw), "
      "\"style_keys\", \"styles\", \"stroke_kinds\", "
      "\"formats\".");
  module.def("info", info, "What `burin info --json` prints, one entry a file. Throws InputError.");
}

}  // namespace burin::python
