#pragma once
// A shape as a formula over its leaves where they stand; for csg/solids alone.

#include <burin/base/box.h>

#include "boolean.h"
#include "shapes.h"

#include <map>
#include <unordered_map>
#include <utility>

namespace burin::csg {

class Gather {
 public:
  explicit Gather(const Shapes& shapes) : shapes_(shapes) {}

  struct PlacedMesh {
    std::uint32_t leaf = 0, matrix = 0;
    bool tangled = false, open = false;
    std::uint32_t from = kNothing;
    Box3 box;
  };
  /// Node 0 is a union, whose children are what may be apart.
  Formula formula;
  std::vector<PlacedMesh> leaves;
  std::vector<ExactMatrix> matrices;
  /// What stands for each child of node 0, in their order, and the union that it is directly in.
  struct Child {
    ShapeId shape = kNothing;
    std::uint32_t matrix = 0, within = kNothing;
  };
  std::vector<Child> children;
  /// The unions that node 0 is made of, outer ones before inner ones, each where it stands; all
  /// children of one stand beside each other, from `first` on.
  struct Within {
    ShapeId shape = kNothing;
    std::uint32_t matrix = 0, parent = kNothing, depth = 0, first = kNothing;
  };
  std::vector<Within> unions;

  void run(ShapeId root);

 private:
  using Kind = Shapes::Kind;
  struct Open {
    ShapeId shape;
    std::uint32_t parent, matrix, within;
  };

  void step(Open o);
  std::uint32_t node(Formula::Kind kind, std::uint32_t parent);
  void nest(Formula::Kind kind, const Shapes::Shape& s, Open o);
  void cut(Open o);
  std::uint32_t product(std::uint32_t outer, std::uint32_t inner);
  void stand(const Shapes::Shape& s, Open o);
  void find_first();

  const Shapes& shapes_;
  std::vector<Open> open_;
  std::unordered_map<std::size_t, std::vector<std::uint32_t>> by_value_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> places_;
};

}  // namespace burin::csg
