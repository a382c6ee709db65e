#pragma once
/// What a call of `draw`, `items` or `explode_steps` asks: its source and its keywords.

#include <burin/converters/illustration.h>
#include <burin/converters/request.h>

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

/// What is to be drawn: a scene, or files to be read in the run.
class Source {
 public:
  /// A Scene, a mapping, a path or several. Throws UsageError, TypeError.
  explicit Source(const py::object& value);

  bool is_scene() const { return scene_.has_value(); }
  /// Null where it is none.
  const IllustrationFile* illustration() const { return illustration_ ? &*illustration_ : nullptr; }
  /// Of a scene's parts.
  const std::vector<PartStyle>& part_styles() const { return part_styles_; }

  /// Once, in the run. Throws InputError.
  Scene get(const ReadOptions& options, RunContext& context);

 private:
  std::optional<Scene> scene_;
  std::vector<PartStyle> part_styles_;
  std::vector<std::string> paths_;
  std::optional<IllustrationFile> illustration_;
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
  Source from;
  With with;
  DrawPlan plan;

  /// Keywords over what `illustration=` says, and that over the source's own. Throws UsageError
  /// that names the keyword, TypeError.
  Call(const py::object& source, const py::kwargs& keywords);

  /// The scene, once, in the run; the plan follows what its files say of the drawing, below all
  /// that the call says. Throws InputError.
  Scene read(RunContext& context);

 private:
  DrawRequest request_;
};

}  // namespace burin::python
