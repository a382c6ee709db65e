#pragma once
// Errors and words that say which node of a tree they are about; for converters/openscad alone.

#include <burin/base/error.h>

#include "exchange.h"
#include "flat/flat.h"

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

/// Something that OpenSCAD warns of and goes on without; `what` begins with a module, or is of that
/// of the node.
inline void report(Evaluation& e, std::uint32_t node, std::string code, const std::string& what) {
  const bool named = what.find("()") != std::string::npos;
  const std::string of = named ? "" : fmt::format("{}(): ", name_of(e.tree.nodes[node].module));
  e.diagnostics.add(Severity::Warning, std::move(code), 1,
                    fmt::format("line {}{}{}{}", e.tree.line_of(node), kOfTree, of, what));
}

}  // namespace burin::csg
