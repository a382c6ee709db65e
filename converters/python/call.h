#pragma once
/// What a call of `draw`, `items` or `explode_steps` asks: its source and its keywords.

#include <burin/converters/plan.h>

#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace burin::python {

namespace py = pybind11;

/// What Python calls `Session`.
struct PySession {
  Session session;
  std::mutex busy;
};

/// Functions and objects of the program that calls, beside options.
struct With {
  py::object field = py::none(), tone = py::none(), progress = py::none(), cancel = py::none(),
             session = py::none();

  /// Null where it is none of these.
  py::object* find(const std::string& name);
  /// Null for None. Throws TypeError.
  PySession* python_session() const;
};

struct Call {
  With with;
  DrawTask task;

  /// The source is a Scene, a mapping, a path or several. Keywords go over what `illustration=`
  /// says, and that over the source's own. Throws UsageError that names the keyword, TypeError.
  Call(const py::object& source, const py::kwargs& keywords);

  DrawPlan& plan() { return task.plan; }
  /// The scene, once, in the run. Throws InputError.
  Scene read(RunContext& context) { return task.follow(task.read(context)); }
};

}  // namespace burin::python
