#pragma once
// Parts of a tree: what a program shows as things of their own; internal to the module.

#include <burin/base/diagnostics.h>

#include "calls.h"
#include "marks.h"
#include "tree.h"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace burin::detail {

/// Nodes that are one part together, each where it stands.
struct TreePart {
  struct Piece {
    std::uint32_t node = 0;
    /// In the part's frame.
    csg::Matrix at;
  };
  /// Of no other part, or of none in its assembly.
  std::string name;
  /// Of no other part or assembly: what the parts of one call or part() are together where their
  /// looks tell several of them apart; these follow each other.
  std::string assembly;
  /// What it is an instance of: the module that is called, the name that part() gives; or empty.
  std::string definition;
  /// "#rrggbb", or empty.
  std::string color;
  double opacity = 1;
  /// `%` and `#`.
  bool background = false, highlight = false;
  /// Whether it is a call or a part(), or some of one, not of an object that holds several things.
  bool of_one = false;
  /// The node of the object, the call or the part() that it is, or is some of.
  std::uint32_t of = 0;
  csg::Matrix frame;
  std::vector<Piece> pieces;
};

/// What burin.scad says of the parts below one of its calls.
struct PartCall {
  Mark mark;
  csg::Matrix at;
  /// Numbers of parts.
  std::vector<std::size_t> parts;
};

struct TreeParts {
  std::vector<TreePart> parts;
  std::vector<PartCall> calls;
  /// Of view(); the last one holds.
  std::vector<Mark> views;
};

/// Calls that are parts of their own: their nodes.
struct CallParts {
  /// nullptr: nothing is known of calls.
  const TreeCalls* known = nullptr;
  std::set<std::uint32_t> nodes = {};
  /// Calls that are left out, as others make the same in their places.
  std::set<std::uint32_t> repeated = {};
};

/// Objects at the top, or those of the first `!`, are parts, and so are `calls` within them and
/// what each call of part() holds; within one, color() and what burin.scad says of children make
/// parts of their own, unless they lie within a difference or another module that makes one thing
/// of its children. `%` and `#` show theirs beside them, wherever they stand. Names of one kind get
/// " #2", " #3". `program`: the text that the tree was made from, for the names of objects at the
/// top; `stem`: what objects without any are called. Throws InputError.
TreeParts parts_of(const csg::Tree& tree, std::string_view program, const std::string& stem,
                   Diagnostics& diagnostics, const CallParts& calls = {});

/// Says ("openscad.undefined_place") how many transformations by numbers that are not finite there
/// are.
void report_undefined_places(const csg::Tree& tree, Diagnostics& diagnostics);

/// Objects at the top, or the first `!`: what is above it does not move it, OpenSCAD shows it
/// alone.
std::vector<std::uint32_t> objects_at_top(const csg::Tree& tree);

/// Modules that show their children as they are.
bool is_open(csg::Module module);

/// Whether a part has facets of which its program does not say what they mean: polyhedra, polygons,
/// text, files, sums. They may stand for something round. Height maps do not count: their steps of
/// brightness look like strips of cylinders.
bool has_unknown_facets(const csg::Tree& tree, const TreePart& part);

/// Whether what a tree makes is flat, as far as its modules tell: no file is opened.
bool is_flat(const csg::Tree& tree);

}  // namespace burin::detail
