#pragma once
// Solids that are not worked out yet: what is to be united, cut and moved; for csg/solids alone.

#include <burin/base/box.h>
#include <burin/base/run_context.h>

#include "../solid.h"
#include "number.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace burin::csg {

using ShapeId = std::uint32_t;
inline constexpr ShapeId kNothing = ~ShapeId{0};

/// A store of shapes that share their parts. Nothing is cut before `solid` asks for it, and then
/// all of it in one step for whatever touches.
class Shapes {
 public:
  /// `from`: of a leaf that may be open or cut itself, the node that says so in messages; else
  /// kNothing.
  ShapeId leaf(Solid solid, std::uint32_t from = kNothing);
  ShapeId united(std::vector<ShapeId> parts);
  /// The first without the others. Nothing where the first is nothing.
  ShapeId difference(std::vector<ShapeId> parts);
  /// Nothing where one of them is.
  ShapeId intersection(std::vector<ShapeId> parts);
  ShapeId moved(ShapeId shape, const Matrix& m);

  /// Works a shape out. A single leaf stays as it is, unless it is to be freed of cuts through
  /// itself and corners in one place (`clean`). Throws GeometryError where that cannot be done.
  Solid solid(ShapeId root, RunContext& context, const std::function<void(double)>& share,
              bool clean = false);
  /// All corners of the leaves of a shape of unions alone; of others of what it works out to.
  std::vector<Vec3> points(ShapeId root, RunContext& context);
  /// The nodes of open leaves that something was to be cut by or united with: they were left out.
  std::vector<std::uint32_t> left_out;
  /// How many groups of solids that touch were cut; what is alike counts once.
  std::size_t cuts = 0;
  /// What is under way, in words.
  std::string doing;
  /// How many nodes of cuts stand within each other.
  std::uint32_t depth(ShapeId shape) const { return shape == kNothing ? 0 : shapes_[shape].depth; }

 private:
  enum class Kind : std::uint8_t { Leaf, Union, Difference, Intersection, Moved };
  struct Shape {
    Kind kind = Kind::Leaf;
    bool tangled = false, open = false;
    std::uint32_t from = kNothing;
    /// No cuts below.
    bool plain = true;
    std::uint32_t depth = 0;
    std::uint32_t leaf = 0, matrix = 0;
    std::vector<ShapeId> parts;
  };
  /// A group that was cut, and where it stood.
  struct Known {
    std::shared_ptr<const Solid> solid;
    ExactMatrix at;
  };
  friend class Gather;
  friend class WorkOut;

  ShapeId add(Kind kind, std::vector<ShapeId> parts);

  std::vector<Shape> shapes_;
  std::vector<Solid> leaves_;
  std::vector<Matrix> matrices_;
  std::map<std::vector<std::uint32_t>, Known> known_;
  /// Triangles of all that was to be cut, and of what is known.
  std::size_t to_cut_ = 0, kept_ = 0;
};

}  // namespace burin::csg
