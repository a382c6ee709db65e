#pragma once
// What samples/openscad/burin.scad leaves in a tree; internal to the module.

#include "tree.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace burin::detail {

/// One call of a module of burin.scad: its name and its arguments, in the order of its declaration.
struct Mark {
  std::string what;
  nlohmann::ordered_json arguments;
};

/// What a polyhedron() says instead of being one; nothing where it is no mark. They hold no faces,
/// so that OpenSCAD itself makes nothing of them. Throws InputError where a mark is broken.
std::optional<Mark> mark_at(const csg::Tree& tree, std::uint32_t node);

/// The mark of the module call that a group stands for: that of its first child.
std::optional<Mark> mark_of_group(const csg::Tree& tree, std::uint32_t node);

}  // namespace burin::detail
