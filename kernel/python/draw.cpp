#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/converters/read.h>
#include <burin/converters/request.h>
#include <burin/converters/values.h>

#include "drawing.h"
#include "fields.h"
#include "module.h"
#include "read.h"
#include "run.h"
#include "scene.h"
#include "style_text.h"
#include "text.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace burin::python {
namespace {

/// What `draw` was given, in the order of its signature.
struct Keywords {
  py::object view, up, perspective, paper, scale, margin, style, set, light, hidden, tolerance,
      seed, threads, center, verify;
};

std::string word(const char* name, const py::object& value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  throw py::type_error(
      fmt::format("argument {} takes a word, not {}", name, std::string(py::repr(value))));
}

DrawRequest request_of(const Keywords& k) {
  DrawRequest r;
  r.view = list_text("view", k.view);
  r.up = list_text("up", k.up);
  r.perspective = number_text("perspective", k.perspective);
  r.paper = list_text("paper", k.paper, "x");
  r.scale = number_text("scale", k.scale);
  r.center = list_text("center", k.center);
  r.margin = k.margin.is_none() ? "" : value_text("margin", k.margin);
  set_style(r, k.style);
  if (!k.set.is_none()) r.set = assignments(k.set);
  r.light = list_text("light", k.light);
  r.hidden = word("hidden", k.hidden);
  r.tolerance = number_text("tolerance", k.tolerance);
  r.seed = number_text("seed", k.seed);
  r.threads = number_text("threads", k.threads);
  r.verify = std::string(py::str(k.verify));
  return r;
}

/// What is to be drawn: a scene, or files to be read in the run.
struct Source {
  std::optional<Scene> scene;
  std::vector<PartLook> looks;
  std::vector<std::string> paths;

  explicit Source(const py::object& value) {
    if (py::isinstance<PyScene>(value)) {
      const auto& given = value.cast<const PyScene&>();
      scene = given.scene;
      looks = given.looks;
    } else {
      paths = path_list(value);
      if (paths.empty()) throw UsageError("no input; name model files, or give a scene");
    }
  }

  Scene get(const ReadOptions& options, RunContext& context) {
    if (scene) return std::move(*scene);
    check_inputs(paths);
    return read_scene(paths, options, context);
  }
};

DrawingOwner draw(const py::object& source, const py::object& view, const py::object& up,
                  const py::object& perspective, const py::object& paper, const py::object& scale,
                  const py::object& margin, const py::object& style, const py::object& set,
                  const py::object& light, const py::object& hidden, const py::object& tolerance,
                  const py::object& bounds, const py::object& seed, const py::object& threads,
                  const py::object& center, const py::object& verify, const py::object& id_prefix,
                  const py::object& field, const py::object& tone, const py::object& progress,
                  const py::object& cancel, const py::kwargs& options) {
  Source from(source);
  const ReadOptions read = read_options(
      bounds, options,
      {"view",   "up",     "perspective", "paper",     "scale",  "margin",   "style",
       "set",    "light",  "hidden",      "tolerance", "bounds", "seed",     "threads",
       "center", "verify", "id_prefix",   "field",     "tone",   "progress", "cancel"});
  if (from.scene && (!bounds.is_none() || !options.empty())) {
    throw UsageError(
        "arguments about reading (bounds ...) go to Scene.read, not to the scene's draw");
  }
  DrawPlan plan = make_plan(request_of({view, up, perspective, paper, scale, margin, style, set,
                                        light, hidden, tolerance, seed, threads, center, verify}),
                            Spelling::Keywords);
  plan.read = read;
  plan.illustrate.field = python_field(field);
  plan.illustrate.tone = python_tone(tone);
  if (!field.is_none()) plan.about_strokes.emplace_back("argument field");
  if (!tone.is_none()) plan.about_strokes.emplace_back("argument tone");
  if (from.scene) plan.illustrate.looks = from.looks;
  const auto flag = cancel_flag(cancel);
  auto result = std::make_shared<PyDrawing>();
  result->style = plan.style;
  result->id_prefix = id_prefix_option("id_prefix", word("id_prefix", id_prefix));
  run(progress, flag, [&](RunContext& context) {
    const ThreadLimit limit(plan.threads);
    const Scene scene = from.get(plan.read, context);
    const Camera camera = make_camera(scene, plan);
    result->drawing = burin::draw(scene, camera, plan, context);
  });
  return result;
}

py::list info(const py::args& paths, const py::kwargs& options) {
  std::vector<std::string> names;
  for (const py::handle path : paths) names.push_back(path_text(path));
  if (names.empty()) throw UsageError("no input; name model files");
  const ReadOptions read = read_options(py::none(), options);
  std::vector<FileInfo> files;
  run(py::none(), nullptr, [&](RunContext& context) {
    check_inputs(names);
    context.begin_stage("read");
    for (const std::string& name : names) files.push_back(inspect_file(name, read, context));
    context.end_stage();
  });
  return py::module_::import("json").attr("loads")(to_json(files))["files"];
}

}  // namespace

void add_draw(py::module_& module) {
  module.def(
      "draw", draw, py::arg("source"), py::kw_only(), py::arg("view") = "iso",
      py::arg("up") = py::none(), py::arg("perspective") = py::none(), py::arg("paper") = "A4",
      py::arg("scale") = py::none(), py::arg("margin") = 10, py::arg("style") = "technical",
      py::arg("set") = py::none(), py::arg("light") = py::none(), py::arg("hidden") = "none",
      py::arg("tolerance") = py::none(), py::arg("bounds") = py::none(), py::arg("seed") = 1,
      py::arg("threads") = py::none(), py::arg("center") = py::none(), py::arg("verify") = false,
      py::arg("id_prefix") = "", py::arg("field") = py::none(), py::arg("tone") = py::none(),
      py::arg("progress") = py::none(), py::arg("cancel") = py::none(),
      "What burin.draw calls; that one tells its arguments.");
  module.def("info", info, "What `burin info --json` tells, one entry a file. Throws InputError.");
}

}  // namespace burin::python
