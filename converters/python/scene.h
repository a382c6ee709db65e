#pragma once
/// Scenes as Python holds them.

#include <burin/converters/read_result.h>
#include <burin/illustrate/illustrate.h>

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

namespace burin::python {

namespace py = pybind11;

struct PyScene {
  Scene scene;
  /// Of the files that it was read from.
  std::vector<ModelMarks> marks = {};
  /// One per part.
  std::vector<PartStyle> part_styles = {};
};

/// One part of a scene, which it keeps.
struct PyPart {
  std::shared_ptr<PyScene> owner;
  std::size_t index = 0;

  Part& part() const { return owner->scene.parts[index]; }
  PartStyle& look() const { return owner->part_styles[index]; }
};

/// Diagnostics as a list.
py::list to_list(const Diagnostics& diagnostics);

}  // namespace burin::python
