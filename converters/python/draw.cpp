#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/catalogues.h>
#include <burin/converters/illustration.h>
#include <burin/converters/messages.h>
#include <burin/converters/read.h>
#include <burin/converters/request.h>

#include "drawing.h"
#include "fields.h"
#include "illustration.h"
#include "module.h"
#include "read.h"
#include "run.h"
#include "scene.h"
#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

namespace burin::python {
namespace {

/// What `draw` was given beside options.
struct Calls {
  py::object field = py::none(), tone = py::none(), progress = py::none(), cancel = py::none(),
             session = py::none();

  /// Null where it is none of these.
  py::object* find(const std::string& name) {
    if (name == "field") return &field;
    if (name == "tone") return &tone;
    if (name == "progress") return &progress;
    if (name == "session") return &session;
    return name == "cancel" ? &cancel : nullptr;
  }
};
const std::vector<std::string> kCalls = {"field", "tone", "progress", "cancel", "session"};

bool is_about_reading(const std::string& name) {
  return std::ranges::any_of(read_option_rows(),
                             [&](const auto& row) { return row.name() == name; });
}

/// What Python calls `Session`.
struct PySession {
  Session session;
  std::mutex busy;
};

/// Null for None.
PySession* session_of(const py::object& value) {
  if (value.is_none()) return nullptr;
  if (!py::isinstance<PySession>(value)) {
    throw py::type_error("argument session takes a Session");
  }
  return value.cast<PySession*>();
}

/// What is to be drawn: a scene, or files to be read in the run.
struct Source {
  std::optional<Scene> scene;
  std::vector<PartStyle> part_styles;
  std::vector<std::string> paths;
  std::optional<Illustration> illustration;

  explicit Source(const py::object& value) {
    if (py::isinstance<PyScene>(value)) {
      const auto& given = value.cast<const PyScene&>();
      scene = given.scene;
      part_styles = given.part_styles;
    } else if (is_mapping(value)) {
      illustration = illustration_of(value);
    } else {
      paths = path_list(value);
      if (paths.empty()) throw UsageError("no input; name model files, or give a scene");
      if (paths.size() == 1 && is_illustration(paths.front())) {
        illustration = illustration_of(py::str(paths.front()));
      }
    }
  }

  Scene get(const ReadOptions& options, RunContext& context) {
    if (scene) return std::move(*scene);
    if (illustration) return read_scene(*illustration, context);
    check_inputs(paths);
    return read_scene(paths, options, context);
  }
};

DrawingOwner draw(const py::object& source, const py::kwargs& keywords) {
  Source from(source);
  Calls calls;
  DrawRequest request;
  for (const auto& [key, value] : keywords) {
    const auto name = key.cast<std::string>();
    if (py::object* call = calls.find(name)) {
      *call = py::reinterpret_borrow<py::object>(value);
      continue;
    }
    if (!value.is_none() && is_about_reading(name)) {
      if (from.scene) {
        throw UsageError(
            "arguments about reading (bounds ...) go to Scene.read, not to the scene's draw");
      }
      if (from.illustration) {
        throw UsageError(
            "arguments about reading (bounds ...) belong to a part of the illustration");
      }
    }
    add_keyword(request, find_option(all_options(), name, kCalls), value);
  }
  if (from.illustration) request = merged(from.illustration->request, request);
  const auto& [field, tone, progress, cancel, kept] = calls;
  PySession* const session = session_of(kept);
  DrawPlan plan = make_plan(request, Spelling::Keywords);
  plan.illustrate.field = python_field(field);
  plan.illustrate.tone = python_tone(tone);
  if (!field.is_none()) plan.about_strokes.emplace_back("argument field");
  if (!tone.is_none()) plan.about_strokes.emplace_back("argument tone");
  if (from.scene) plan.illustrate.part_styles = from.part_styles;
  const auto flag = cancel_flag(cancel);
  auto result = std::make_shared<PyDrawing>();
  result->style = plan.style;
  result->id_prefix = plan.id_prefix;
  std::unique_lock<std::mutex> busy;
  if (session) {
    busy = std::unique_lock(session->busy, std::try_to_lock);
    if (!busy) throw UsageError("the session is drawing already; one drawing at a time");
  }
  run(progress, flag, [&](RunContext& context) {
    const ThreadLimit limit(plan.threads);
    Scene scene = from.get(plan.read, context);
    arrange_parts(scene, plan, context);
    const SheetOfViews sheet = plan_sheet(scene, plan);
    result->drawing =
        burin::draw(scene, sheet, plan, context, session ? &session->session : nullptr);
    write_parts_lists(result->drawing, plan);
  });
  return result;
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
      files.back().diagnostics = at_door(files.back().diagnostics, Spelling::Keywords);
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
             "What burin.draw calls; that one tells its arguments.");
  module.def(
      "catalogues", [] { return py::module_::import("json").attr("loads")(catalogues_json()); },
      "All that can be chosen, as `burin options --json` tells it: \"options\" (of draw), "
      "\"style_keys\", \"styles\", \"stroke_kinds\", "
      "\"formats\".");
  module.def("info", info, "What `burin info --json` tells, one entry a file. Throws InputError.");
}

}  // namespace burin::python
