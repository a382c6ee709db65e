#pragma once
// The tree of a .csg text, as OpenSCAD writes it once a program has run; for converters/openscad
// alone.

#include <burin/base/run_context.h>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace burin::csg {

/// Every module that OpenSCAD 2021.01 writes, and of later ones those that it knew. What its users
/// call translate, rotate, scale and mirror is a multmatrix there, their own modules and loops are
/// groups.
enum class Module : std::uint8_t {
  Cube,
  Sphere,
  Cylinder,
  Polyhedron,
  Square,
  Circle,
  Polygon,
  Text,
  Import,
  Surface,
  LinearExtrude,
  RotateExtrude,
  Projection,
  Offset,
  Resize,
  Minkowski,
  Hull,
  Union,
  Difference,
  Intersection,
  Group,
  Render,
  Color,
  Multmatrix
};
std::string_view name_of(Module module);
/// Whether a module alone says that it makes a solid, or a flat shape; of files their names do.
bool makes_solid(Module module);
bool makes_flat(Module module);

/// What an argument says: nothing, a truth, a number, a text or a list.
struct Value {
  enum class Kind : std::uint8_t { Undef, Bool, Number, String, List };
  Kind kind = Kind::Undef;
  double number = 0;
  std::string text;
  std::vector<Value> list;

  bool is_list() const { return kind == Kind::List; }
};

struct Argument {
  /// Empty where the text gives none.
  std::string name;
  Value value;
};

struct Node {
  Module module = Module::Group;
  /// `%`: shown, no part of the result; `#`: stressed; `!`: nothing else is drawn.
  bool background = false, highlight = false, root = false;
  std::vector<Argument> arguments;
  /// The number behind the last node below this one: children are [own number + 1, end), the next
  /// brother begins there.
  std::uint32_t end = 0;
  /// Where it stands in the text: bytes [begin, finish) from its name on, without modifiers.
  std::size_t begin = 0, finish = 0;

  /// nullptr where the argument is absent.
  const Value* argument(std::string_view name) const;
  /// `fallback` where the argument is absent or undef. Throws InputError where it is no number.
  double number(std::string_view name, double fallback) const;
  bool truth(std::string_view name, bool fallback) const;
  std::string text(std::string_view name) const;
  /// A list of numbers; empty where absent or undef. Throws InputError where it is none.
  std::vector<double> numbers(std::string_view name) const;
};

/// Nodes before their children, in the order of the text; node 0 is a group of all that stands at
/// the top, which OpenSCAD unites.
struct Tree {
  std::string source;
  /// Named in errors.
  std::string file;
  std::vector<Node> nodes;

  std::string_view text_of(std::uint32_t node) const {
    const Node& n = nodes[node];
    return std::string_view(source).substr(n.begin, n.finish - n.begin);
  }
  /// From 1 on.
  std::int64_t line_of(std::uint32_t node) const;
};

/// Calls `visit(child)` for the children of a node, in order.
template <typename Visit>
void for_each_child(const Tree& tree, std::uint32_t node, Visit&& visit) {
  for (std::uint32_t c = node + 1; c < tree.nodes[node].end; c = tree.nodes[c].end) visit(c);
}

/// Rows of a multmatrix; the identity for other nodes. Throws InputError with file and line where
/// the list is no matrix of finite numbers.
struct Matrix {
  std::array<std::array<double, 4>, 3> row{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  Matrix operator*(const Matrix& other) const;
  std::array<double, 3> operator*(const std::array<double, 3>& p) const;
  double determinant() const;
  bool operator==(const Matrix&) const = default;
};
/// That of a multmatrix(), the identity of other nodes. Numbers that are not finite make nothing of
/// what stands below, as in OpenSCAD: zeros.
Matrix matrix_of(const Tree& tree, std::uint32_t node);

/// Of a linear_extrude(), how much larger the top is than the foot. OpenSCAD of today writes one
/// number for two that are the same, and none for 1.
std::array<double, 2> top_scale(const Node& node);

/// What OpenSCAD of today may write and the evaluator does not know, named as in a message; empty
/// where there is nothing of the kind.
std::string not_known_in(const Tree& tree);

/// Whether all nodes have the arguments that OpenSCAD writes for them: a program that looks like a
/// tree may leave some out, or say them otherwise.
bool is_canonical(const Tree& tree);

/// Reads a text. Throws InputError with file and line: what is no tree, a module that is none of
/// the above (as in a program that OpenSCAD has not run yet). Any depth; cost: about 10 MB of text
/// a second. Polls `context`.
Tree parse(std::string source, std::string file, RunContext& context);

}  // namespace burin::csg
