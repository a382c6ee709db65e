#pragma once
// The evaluator of trees, in a process of its own; for converters/openscad alone.

#include <burin/base/diagnostics.h>
#include <burin/base/error.h>
#include <burin/base/run_context.h>

#include "solid.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace burin::csg {

/// The evaluator could not do it: it crashed, ran out of memory or found a cut that it cannot make.
/// One sentence; who has another evaluator asks that one.
class NotEvaluated : public Error {
 public:
  using Error::Error;
};

struct ChildOptions {
  /// Where relative file names of the tree begin.
  std::filesystem::path folder;
  /// Named in errors.
  std::string file;
  /// Names the place of a line of the text in words of the user, who does not know the text: "in
  /// arm"; empty where there is none.
  std::function<std::string(std::int64_t line)> where = {};
  double timeout_seconds = 1e9;
};

/// The solids of nodes of a text (numbers as `parse` gives them), as `evaluate` of
/// solids/evaluate.h says. A library that crashes takes that process alone. Throws InputError with
/// file and place for what a tree may not ask for (a circle of 1e9 corners), NotEvaluated,
/// Cancelled within 0.1 s. What the user should know goes to `diagnostics`.
std::vector<Solid> evaluate_in_child(const std::string& text, std::span<const std::uint32_t> nodes,
                                     const ChildOptions& options, RunContext& context,
                                     Diagnostics& diagnostics);

}  // namespace burin::csg
