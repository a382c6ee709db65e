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
void check_place(const std::string& name, const DrawInputs& inputs) {
  if (!is_about_reading(name)) return;
  if (inputs.given) {
    throw UsageError("argument " + name +
                     " is about reading: give it to Scene.read, not to the scene's draw");
  }
  if (inputs.illustration) {
    throw UsageError("argument " + name +
                     " is about reading: in an illustration it belongs to a part, {\"file\": ...}");
  }
}

DrawInputs inputs_of(const py::object& source) {
  if (py::isinstance<PyScene>(source)) {
    const auto& scene = source.cast<const PyScene&>();
    return {.given = ReadResult{scene.scene, scene.marks}, .part_styles = scene.part_styles};
  }
  if (is_mapping(source)) return {.illustration = illustration_of(source)};
  const std::vector<std::string> files = path_list(source);
  if (files.empty()) throw UsageError("no input; name model files, or give a scene");
  return find_inputs(files);
}

DrawRequest request_of(const DrawInputs& inputs, const py::kwargs& keywords, With& with) {
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
    if (!value.is_none()) check_place(name, inputs);
    add_keyword(request, option_asked(name, known_words(kCalls), Spelling::Keywords), value);
  }
  return merged(over, request);
}

DrawTask task_of(DrawInputs inputs, const py::kwargs& keywords, With& with) {
  const DrawRequest request = request_of(inputs, keywords, with);
  return {std::move(inputs), request, Spelling::Keywords};
}

}  // namespace

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

Call::Call(const py::object& source, const py::kwargs& keywords)
    : task(task_of(inputs_of(source), keywords, with)) {
  plan().illustrate.field = python_field(with.field);
  plan().illustrate.tone = python_tone(with.tone);
  if (!with.field.is_none()) plan().asked_keys.push_back({"argument field", "hatch.field"});
  if (!with.tone.is_none()) plan().asked_keys.push_back({"argument tone", "tone.law"});
}

}  // namespace burin::python
