#pragma once
// Errors and words that say which node of a tree they are about; for converters/openscad alone.

#include <burin/base/error.h>

#include "flat.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace burin::csg {

/// What `evaluate` returns; an InputError of it that names no file gets the node's line.
template <typename Evaluate>
auto at_node(const Evaluation& e, std::uint32_t node, Evaluate&& evaluate) {
  try {
    return std::forward<Evaluate>(evaluate)();
  } catch (const InputError& error) {
    if (!error.file().empty()) throw;
    throw InputError(error.what(), e.tree.file, e.tree.line_of(node));
  }
}

/// Something that OpenSCAD warns of and goes on without.
inline void tell(Evaluation& e, std::uint32_t node, std::string code, const std::string& what) {
  e.diagnostics.add(Severity::Warning, std::move(code), 1,
                    fmt::format("line {} of the evaluated tree: {}", e.tree.line_of(node), what));
}

}  // namespace burin::csg
