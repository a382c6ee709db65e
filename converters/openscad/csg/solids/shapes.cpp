#include "shapes.h"

#include "gather.h"
#include "places.h"
#include "primitives.h"

#include <algorithm>

namespace burin::csg {

ShapeId Shapes::leaf(Solid solid, std::uint32_t from) {
  if (solid.empty()) return kNothing;
  Shape shape;
  shape.leaf = static_cast<std::uint32_t>(leaves_.size());
  shape.tangled = from != kNothing;
  shape.open = shape.tangled && !closed(solid);
  shape.from = from;
  leaves_.push_back(std::move(solid));
  shapes_.push_back(std::move(shape));
  return static_cast<ShapeId>(shapes_.size() - 1);
}

ShapeId Shapes::add(Kind kind, std::vector<ShapeId> parts) {
  Shape shape;
  shape.kind = kind;
  shape.plain = kind == Kind::Union || kind == Kind::Moved;
  for (const ShapeId p : parts) {
    shape.plain = shape.plain && shapes_[p].plain;
    shape.depth = std::max(shape.depth, shapes_[p].depth);
  }
  if (kind == Kind::Difference || kind == Kind::Intersection) ++shape.depth;
  shape.parts = std::move(parts);
  shapes_.push_back(std::move(shape));
  return static_cast<ShapeId>(shapes_.size() - 1);
}

ShapeId Shapes::united(std::vector<ShapeId> parts) {
  std::erase(parts, kNothing);
  if (parts.empty()) return kNothing;
  return parts.size() == 1 ? parts[0] : add(Kind::Union, std::move(parts));
}

ShapeId Shapes::difference(std::vector<ShapeId> parts) {
  if (parts.empty() || parts[0] == kNothing) return kNothing;
  std::erase(parts, kNothing);
  return parts.size() == 1 ? parts[0] : add(Kind::Difference, std::move(parts));
}

ShapeId Shapes::intersection(std::vector<ShapeId> parts) {
  if (parts.empty() || std::ranges::find(parts, kNothing) != parts.end()) return kNothing;
  return parts.size() == 1 ? parts[0] : add(Kind::Intersection, std::move(parts));
}

ShapeId Shapes::moved(ShapeId shape, const Matrix& m) {
  if (shape == kNothing || m.determinant() == 0) return kNothing;
  if (m == Matrix{}) return shape;
  const ShapeId id = add(Kind::Moved, {shape});
  shapes_[id].matrix = static_cast<std::uint32_t>(matrices_.size());
  matrices_.push_back(m);
  return id;
}

std::vector<Vec3> Shapes::points(ShapeId root, RunContext& context) {
  if (root == kNothing) return {};
  if (!shapes_[root].plain) return solid(root, context, [](double) {}).positions;
  Gather all(*this);
  all.run(root);
  std::vector<Vec3> out;
  for (const auto& leaf : all.leaves) {
    for (const Vec3& p : leaves_[leaf.leaf].positions) {
      const auto q = all.matrices[leaf.matrix].nearest * std::array<double, 3>{p.x, p.y, p.z};
      out.emplace_back(q[0], q[1], q[2]);
    }
  }
  return out;
}

}  // namespace burin::csg
