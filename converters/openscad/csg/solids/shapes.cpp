#include "shapes.h"

#include <burin/base/disjoint_sets.h>

#include "boolean.h"
#include "places.h"
#include "primitives.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

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

/// The formula of a shape and its leaves where they stand.
class Gather {
 public:
  explicit Gather(const Shapes& shapes) : shapes_(shapes) {}

  struct Standing {
    std::uint32_t leaf = 0, matrix = 0;
    bool tangled = false, open = false;
    std::uint32_t from = kNothing;
    Box3 box;
  };
  Formula formula;
  std::vector<Standing> leaves;
  std::vector<ExactMatrix> matrices;

  /// The root is a union, whose children are what may be apart.
  void run(ShapeId root) {
    matrices.push_back(exact(Matrix{}));
    by_value_[order_of(Matrix{})].push_back(0);
    formula.nodes.push_back({Formula::Kind::Union, 0, {}});
    open_.push_back({root, 0, 0});
    while (!open_.empty()) {
      const Open o = open_.back();
      open_.pop_back();
      step(o);
    }
    // Children were met last first.
    for (auto& node : formula.nodes) {
      if (node.kind != Formula::Kind::Difference) std::ranges::reverse(node.children);
    }
  }

 private:
  using Kind = Shapes::Kind;
  struct Open {
    ShapeId shape;
    std::uint32_t parent, matrix;
  };

  void step(Open o) {
    const Shapes::Shape& s = shapes_.shapes_[o.shape];
    switch (s.kind) {
      case Kind::Moved:
        open_.push_back({s.parts[0], o.parent, product(o.matrix, s.matrix)});
        return;
      case Kind::Leaf:
        stand(s, o);
        return;
      case Kind::Union:
        if (formula.nodes[o.parent].kind == Formula::Kind::Union) {
          for (const ShapeId p : s.parts) open_.push_back({p, o.parent, o.matrix});
          return;
        }
        nest(Formula::Kind::Union, s, o);
        return;
      case Kind::Intersection:
        nest(Formula::Kind::Intersection, s, o);
        return;
      case Kind::Difference:
        cut(o);
        return;
    }
  }

  std::uint32_t node(Formula::Kind kind, std::uint32_t parent) {
    const auto n = static_cast<std::uint32_t>(formula.nodes.size());
    formula.nodes.push_back({kind, 0, {}});
    formula.nodes[parent].children.push_back(n);
    return n;
  }
  void nest(Formula::Kind kind, const Shapes::Shape& s, Open o) {
    const std::uint32_t n = node(kind, o.parent);
    for (const ShapeId p : s.parts) open_.push_back({p, n, o.matrix});
  }

  /// ((A - B) - C) is A - (B + C): the first in a node of its own, all others in one union.
  void cut(Open o) {
    const std::uint32_t n = node(Formula::Kind::Difference, o.parent);
    const std::uint32_t first = node(Formula::Kind::Union, n);
    const std::uint32_t rest = node(Formula::Kind::Union, n);
    for (Open at = o;;) {
      const Shapes::Shape& s = shapes_.shapes_[at.shape];
      if (s.kind == Kind::Moved) {
        at = {s.parts[0], 0, product(at.matrix, s.matrix)};
      } else if (s.kind == Kind::Difference) {
        for (std::size_t p = 1; p < s.parts.size(); ++p)
          open_.push_back({s.parts[p], rest, at.matrix});
        at = {s.parts[0], 0, at.matrix};
      } else {
        open_.push_back({at.shape, first, at.matrix});
        return;
      }
    }
  }

  std::uint32_t product(std::uint32_t outer, std::uint32_t inner) {
    ExactMatrix m = multiply(matrices[outer], exact(shapes_.matrices_[inner]));
    auto& alike = by_value_[order_of(m.nearest)];
    for (const std::uint32_t k : alike) {
      if (matrices[k].row == m.row) return k;
    }
    alike.push_back(static_cast<std::uint32_t>(matrices.size()));
    matrices.push_back(std::move(m));
    return alike.back();
  }
  static std::size_t order_of(const Matrix& m) {
    std::size_t h = 0;
    for (const auto& row : m.row) {
      for (const double v : row) h = h * 0x100000001b3 ^ std::hash<double>{}(v);
    }
    return h;
  }

  /// A leaf that stands in one place twice is one mesh.
  void stand(const Shapes::Shape& s, Open o) {
    const auto [at, fresh] =
        places_.try_emplace({s.leaf, o.matrix}, static_cast<std::uint32_t>(leaves.size()));
    const auto n = static_cast<std::uint32_t>(formula.nodes.size());
    formula.nodes.push_back({Formula::Kind::Mesh, at->second, {}});
    formula.nodes[o.parent].children.push_back(n);
    if (!fresh) return;
    Standing standing{s.leaf, o.matrix, s.tangled, s.open, s.from, {}};
    for (const Vec3& p : shapes_.leaves_[s.leaf].positions) {
      const auto q = matrices[o.matrix].nearest * std::array<double, 3>{p.x, p.y, p.z};
      standing.box.add(Vec3(q[0], q[1], q[2]));
    }
    leaves.push_back(standing);
  }

  const Shapes& shapes_;
  std::vector<Open> open_;
  std::unordered_map<std::size_t, std::vector<std::uint32_t>> by_value_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> places_;
};

namespace {

double largest(const Box3& b) {
  const Vec3 v = glm::max(glm::abs(b.min), glm::abs(b.max));
  return std::max({v.x, v.y, v.z});
}

void append(Solid& out, const Solid& more) {
  const auto first = static_cast<std::uint32_t>(out.positions.size());
  const auto surfaces = static_cast<std::int32_t>(out.surfaces.size());
  out.positions.insert(out.positions.end(), more.positions.begin(), more.positions.end());
  for (const auto& t : more.triangles)
    out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  for (const std::int32_t s : more.surface) out.surface.push_back(s < 0 ? -1 : s + surfaces);
  out.surfaces.insert(out.surfaces.end(), more.surfaces.begin(), more.surfaces.end());
}

/// A formula's node with all below it, on its own.
Formula excerpt(const Formula& whole, std::span<const std::uint32_t> children,
                std::vector<std::uint32_t>& meshes) {
  Formula out;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  out.nodes.push_back({Formula::Kind::Union, 0, {}});
  struct Open {
    std::uint32_t from, parent;
  };
  std::vector<Open> open;
  for (const std::uint32_t c : children) open.push_back({c, 0});
  for (std::size_t k = 0; k < open.size(); ++k) {
    const auto [from, parent] = open[k];
    const Formula::Node& node = whole.nodes[from];
    const auto n = static_cast<std::uint32_t>(out.nodes.size());
    out.nodes.push_back({node.kind, node.mesh, {}});
    out.nodes[parent].children.push_back(n);
    if (node.kind == Formula::Kind::Mesh) {
      const auto [at, fresh] =
          number.try_emplace(node.mesh, static_cast<std::uint32_t>(meshes.size()));
      if (fresh) meshes.push_back(node.mesh);
      out.nodes[n].mesh = at->second;
    }
    for (const std::uint32_t c : node.children) open.push_back({c, n});
  }
  return out;
}

/// Whether a formula of one mesh is that mesh, which is not so where it is cut by itself.
bool alone(const Formula& formula) {
  return std::ranges::none_of(formula.nodes, [](const Formula::Node& n) {
    return n.kind == Formula::Kind::Difference || n.kind == Formula::Kind::Intersection;
  });
}

/// Which children of the root belong together: their boxes overlap.
std::vector<std::vector<std::uint32_t>> groups(const Formula& formula, std::span<const Box3> box) {
  const auto& children = formula.nodes[0].children;
  std::vector<std::uint32_t> order(children.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto of = [&](std::uint32_t i) -> const Box3& { return box[children[i]]; };
  std::ranges::sort(order, {}, [&](std::uint32_t i) { return of(i).min.x; });
  DisjointSets sets(children.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (std::size_t l = k + 1; l < order.size() && of(order[l]).min.x <= of(order[k]).max.x; ++l) {
      if (of(order[k]).overlaps(of(order[l]))) sets.join(order[k], order[l]);
    }
  }
  std::vector<std::vector<std::uint32_t>> by_set(children.size()), out;
  for (std::uint32_t i = 0; i < children.size(); ++i) by_set[sets.find(i)].push_back(children[i]);
  for (auto& g : by_set) {
    if (!g.empty()) out.push_back(std::move(g));
  }
  return out;
}

/// Only the surfaces that triangles stand for.
void compact(Solid& solid) {
  std::vector<std::int32_t> number(solid.surfaces.size(), -1);
  std::vector<Turned> used;
  for (std::int32_t& s : solid.surface) {
    if (s < 0) continue;
    std::int32_t& n = number[static_cast<std::size_t>(s)];
    if (n < 0) {
      n = static_cast<std::int32_t>(used.size());
      used.push_back(solid.surfaces[static_cast<std::size_t>(s)]);
    }
    s = n;
  }
  solid.surfaces = std::move(used);
}

}  // namespace

Solid Shapes::solid(ShapeId root, RunContext& context, const std::function<void(double)>& share,
                    bool clean) {
  if (root == kNothing) return {};
  Gather all(*this);
  all.run(root);
  const auto& nodes = all.formula.nodes;
  std::vector<Box3> box(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 1;) {
    if (nodes[n].kind == Formula::Kind::Mesh) box[n] = all.leaves[nodes[n].mesh].box;
    for (const std::uint32_t c : nodes[n].children) {
      box[n].add(box[c]);
      if (nodes[n].kind == Formula::Kind::Difference) break;
    }
  }
  Solid out;
  const auto parts = groups(all.formula, box);
  for (std::size_t g = 0; g < parts.size(); ++g) {
    context.check();
    const double done = static_cast<double>(g) / static_cast<double>(parts.size());
    share(done);
    std::vector<std::uint32_t> standing;
    const Formula formula = excerpt(all.formula, parts[g], standing);
    if (standing.size() == 1 && alone(formula) && !(clean && all.leaves[standing[0]].tangled)) {
      const auto& leaf = all.leaves[standing[0]];
      append(out, csg::moved(leaves_[leaf.leaf], all.matrices[leaf.matrix].nearest));
      continue;
    }
    double size = 0;
    for (const std::uint32_t s : standing) size = std::max(size, largest(all.leaves[s].box));
    Space space(size);
    Solid piece;
    std::vector<Mesh> meshes;
    for (const std::uint32_t s : standing) {
      context.check();
      const auto& leaf = all.leaves[s];
      if (leaf.open) {
        left_out.push_back(leaf.from);
        meshes.emplace_back();
        continue;
      }
      const Solid& solid = leaves_[leaf.leaf];
      const ExactMatrix& m = all.matrices[leaf.matrix];
      std::vector<std::int32_t> numbers;
      for (const Turned& t : solid.surfaces) {
        const auto turned = csg::moved(t, m.nearest);
        numbers.push_back(turned ? static_cast<std::int32_t>(piece.surfaces.size()) : -1);
        if (turned) piece.surfaces.push_back(*turned);
      }
      meshes.push_back(mesh_of(space, solid, space.add_matrix(m), m.nearest.determinant() < 0,
                               numbers, leaf.tangled));
    }
    const double width = 1.0 / static_cast<double>(parts.size());
    const Mesh result =
        combine(space, meshes, formula, context, [&](double s) { share(done + s * width); });
    std::vector<Turned> surfaces = std::move(piece.surfaces);
    piece = solid_of(space, result);
    piece.surfaces = std::move(surfaces);
    append(out, piece);
  }
  compact(out);
  return out;
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
