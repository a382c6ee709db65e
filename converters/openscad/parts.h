#pragma once
// Parts of a tree: what a program shows as things of their own; internal to the room.

#include <burin/base/diagnostics.h>

#include "tree.h"

#include <cstdint>
#include <string>
#include <vector>

namespace burin::detail {

/// Nodes that are one part together, each where it stands.
struct TreePart {
  struct Piece {
    std::uint32_t node = 0;
    csg::Matrix at;
  };
  std::string name;
  /// "#rrggbb", or empty.
  std::string color;
  /// `%` and `#`.
  bool background = false, highlight = false;
  std::vector<Piece> pieces;
};

struct TreeParts {
  std::vector<TreePart> parts;
  /// The text of an illustration without parts: what burin.scad and the modifiers ask; or empty.
  std::string settings;
};

/// Objects at the top, or those of the first `!`, are parts; within one, color() and what
/// burin.scad says of children make parts of their own, unless they lie within a difference or
/// another module that makes one thing of its children. `%` and `#` show theirs beside them,
/// wherever they stand. Names of one kind get " #2", " #3". `program`: the text that the tree was
/// made from, for the names of objects at the top; `stem`: what objects without any are called.
/// Throws InputError.
TreeParts parts_of(const csg::Tree& tree, std::string_view program, const std::string& stem,
                   Diagnostics& diagnostics);

/// Whether a part has facets of which its program does not say what they mean: polyhedra, polygons,
/// text, files, sums. They may stand for something round.
bool has_unknown_facets(const csg::Tree& tree, const TreePart& part);

/// Whether what a tree makes is flat, as far as its modules tell: no file is opened.
bool is_flat(const csg::Tree& tree);

}  // namespace burin::detail
