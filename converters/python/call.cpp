#include "call.h"

#include <burin/base/error.h>
#include <burin/converters/read.h>
#include <burin/converters/unknown.h>

#include "fields.h"
#include "illustration.h"
#include "read.h"
#include "scene.h"
#include "text.h"

#include <algorithm>
#include <utility>

namespace burin::python {
namespace {

const std::vector<std::string> kCalls = {"field",  "tone",    "progress",
                                         "cancel", "session", "illustration"};

bool is_about_reading(const std::string& name) {
  return std::ranges::any_of(read_option_rows(),
                             [&](const auto& row) { return row.name() == name; });
}

/// Options about reading belong where the reading is done.
void check_place(const std::string& name, const Source& from) {
  if (!is_about_reading(name)) return;
  if (from.is_scene()) {
    throw UsageError(
        "arguments about reading (bounds ...) go to Scene.read, not to the scene's draw");
  }
  if (from.illustration()) {
    throw UsageError("arguments about reading (bounds ...) belong to a part of the illustration");
  }
}

DrawRequest request_of(const Source& from, const py::kwargs& keywords, With& with) {
  DrawRequest request, over;
  for (const auto& [key, value] : keywords) {
    const auto name = key.cast<std::string>();
    if (py::object* call = with.find(name)) {
      *call = py::reinterpret_borrow<py::object>(value);
      continue;
    }
    if (name == "illustration") {
      if (!value.is_none()) over = settings_of(py::reinterpret_borrow<py::object>(value));
      continue;
    }
    if (!value.is_none()) check_place(name, from);
    add_keyword(request, option_asked(name, known_words(kCalls), Spelling::Keywords), value);
  }
  request = merged(over, request);
  return from.illustration() ? merged(from.illustration()->request, request) : request;
}

}  // namespace

Source::Source(const py::object& value) {
  if (py::isinstance<PyScene>(value)) {
    const auto& given = value.cast<const PyScene&>();
    scene_ = given.scene;
    part_styles_ = given.part_styles;
  } else if (is_mapping(value)) {
    illustration_ = illustration_of(value);
  } else {
    paths_ = path_list(value);
    if (paths_.empty()) throw UsageError("no input; name model files, or give a scene");
    if (paths_.size() == 1 && is_illustration(paths_.front())) {
      illustration_ = illustration_of(py::str(paths_.front()));
    }
  }
}

Scene Source::get(const ReadOptions& options, RunContext& context) {
  if (scene_) return std::move(*scene_);
  if (illustration_) return read_scene(*illustration_, context);
  check_inputs(paths_);
  return read_scene(paths_, options, context);
}

py::object* With::find(const std::string& name) {
  if (name == "field") return &field;
  if (name == "tone") return &tone;
  if (name == "progress") return &progress;
  if (name == "session") return &session;
  return name == "cancel" ? &cancel : nullptr;
}

PySession* With::python_session() const {
  if (session.is_none()) return nullptr;
  if (!py::isinstance<PySession>(session)) {
    throw py::type_error("argument session takes a Session");
  }
  return session.cast<PySession*>();
}

Call::Call(const py::object& source, const py::kwargs& keywords) : from(source) {
  request_ = request_of(from, keywords, with);
  plan = make_plan(request_, Spelling::Keywords);
  plan.illustrate.field = python_field(with.field);
  plan.illustrate.tone = python_tone(with.tone);
  if (!with.field.is_none()) plan.about_strokes.emplace_back("argument field");
  if (!with.tone.is_none()) plan.about_strokes.emplace_back("argument tone");
  if (from.is_scene()) plan.illustrate.part_styles = from.part_styles();
}

Scene Call::read(RunContext& context) {
  Scene scene = from.get(plan.read, context);
  if (from.illustration() || scene.settings.empty()) return scene;
  DrawPlan again = make_plan(with_settings(scene, request_), Spelling::Keywords);
  again.illustrate.field = std::move(plan.illustrate.field);
  again.illustrate.tone = std::move(plan.illustrate.tone);
  again.illustrate.part_styles = std::move(plan.illustrate.part_styles);
  again.about_strokes = std::move(plan.about_strokes);
  again.items = plan.items;
  plan = std::move(again);
  return scene;
}

}  // namespace burin::python
