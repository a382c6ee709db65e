#pragma once
// Which module of a program makes which group of its tree; internal to the module.

#include "tree.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

/// A call of a module in the text of a program.
struct ModuleCall {
  /// That of the innermost module of its chain: `row() bolt();` is a call of "bolt" twice.
  std::string name;
  /// The module itself.
  std::string module;
  /// Whether it stands in the definition of another module, not among the program's statements.
  bool in_module = false;
};

/// A program that makes the same tree, but for a group around each marked call whose first child
/// says which call it is. Lines keep their numbers.
struct MarkedProgram {
  std::string text;
  std::vector<ModuleCall> calls;
};

/// Marks the calls of modules that are not OpenSCAD's own, but for those below what makes one thing
/// of its children (difference, hull, ...). Nothing where there are none, or where the text is not
/// understood. Linear in the text.
std::optional<MarkedProgram> mark_calls(std::string_view program);

/// Of each node of a tree the call that its group stands around.
struct TreeCalls {
  std::vector<ModuleCall> calls;
  /// By node: the number of a call, or -1; empty where nothing is known.
  std::vector<std::int32_t> of;

  const ModuleCall* at(std::uint32_t node) const {
    return node < of.size() && of[node] >= 0 ? &calls[static_cast<std::size_t>(of[node])] : nullptr;
  }
};

/// Takes the marks of `mark_calls` out of a tree, and blanks them in its text.
TreeCalls take_calls(csg::Tree& tree, std::vector<ModuleCall> calls);

}  // namespace burin::detail
