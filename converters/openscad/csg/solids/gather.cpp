#include "gather.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace burin::csg {
namespace {

std::size_t matrix_order(const Matrix& m) {
  std::size_t h = 0;
  for (const auto& row : m.row) {
    for (const double v : row) h = h * 0x100000001b3 ^ std::hash<double>{}(v);
  }
  return h;
}

/// Where a point may be: solids that touch do so too where their corners are rounded apart.
void add_point(Box3& box, const Matrix& at, const std::array<double, 3>& p) {
  constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();
  const auto q = at * p;
  Vec3 reach(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = at.row[i];
    const double size = std::abs(row[0] * p[0]) + std::abs(row[1] * p[1]) +
                        std::abs(row[2] * p[2]) + std::abs(row[3]);
    reach[static_cast<int>(i)] = kRounding * size;
  }
  box.add(Vec3(q[0], q[1], q[2]) - reach);
  box.add(Vec3(q[0], q[1], q[2]) + reach);
}

}  // namespace

void Gather::run(ShapeId root) {
  matrices.push_back(exact(Matrix{}));
  by_value_[matrix_order(Matrix{})].push_back(0);
  formula.nodes.push_back({Formula::Kind::Union, 0, {}});
  open_.push_back({root, 0, 0, kNothing});
  while (!open_.empty()) {
    const Open o = open_.back();
    open_.pop_back();
    step(o);
  }
  // Children were met last first.
  for (auto& node : formula.nodes) {
    if (node.kind != Formula::Kind::Difference) std::ranges::reverse(node.children);
  }
  std::ranges::reverse(children);
  find_first();
}

void Gather::step(Open o) {
  const Shapes::Shape& s = shapes_.shapes_[o.shape];
  if (o.parent == 0 && s.kind != Kind::Moved && s.kind != Kind::Union) {
    children.push_back({o.shape, o.matrix, o.within});
  }
  switch (s.kind) {
    case Kind::Moved:
      open_.push_back({s.parts[0], o.parent, product(o.matrix, s.matrix), o.within});
      return;
    case Kind::Leaf:
      stand(s, o);
      return;
    case Kind::Union:
      if (o.parent == 0) {
        const std::uint32_t depth = o.within == kNothing ? 0 : unions[o.within].depth + 1;
        unions.push_back({o.shape, o.matrix, o.within, depth});
        o.within = static_cast<std::uint32_t>(unions.size() - 1);
      }
      if (formula.nodes[o.parent].kind == Formula::Kind::Union) {
        for (const ShapeId p : s.parts) open_.push_back({p, o.parent, o.matrix, o.within});
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

std::uint32_t Gather::node(Formula::Kind kind, std::uint32_t parent) {
  const auto n = static_cast<std::uint32_t>(formula.nodes.size());
  formula.nodes.push_back({kind, 0, {}});
  formula.nodes[parent].children.push_back(n);
  return n;
}

void Gather::nest(Formula::Kind kind, const Shapes::Shape& s, Open o) {
  const std::uint32_t n = node(kind, o.parent);
  for (const ShapeId p : s.parts) open_.push_back({p, n, o.matrix, kNothing});
}

/// ((A - B) - C) is A - (B + C): the first in a node of its own, all others in one union.
void Gather::cut(Open o) {
  const std::uint32_t n = node(Formula::Kind::Difference, o.parent);
  const std::uint32_t first = node(Formula::Kind::Union, n);
  const std::uint32_t rest = node(Formula::Kind::Union, n);
  for (Open at = o;;) {
    const Shapes::Shape& s = shapes_.shapes_[at.shape];
    if (s.kind == Kind::Moved) {
      at = {s.parts[0], 0, product(at.matrix, s.matrix), kNothing};
    } else if (s.kind == Kind::Difference) {
      for (std::size_t p = 1; p < s.parts.size(); ++p)
        open_.push_back({s.parts[p], rest, at.matrix, kNothing});
      at = {s.parts[0], 0, at.matrix, kNothing};
    } else {
      open_.push_back({at.shape, first, at.matrix, kNothing});
      return;
    }
  }
}

std::uint32_t Gather::product(std::uint32_t outer, std::uint32_t inner) {
  ExactMatrix m = multiply(matrices[outer], exact(shapes_.matrices_[inner]));
  auto& alike = by_value_[matrix_order(m.nearest)];
  for (const std::uint32_t k : alike) {
    if (matrices[k].row == m.row) return k;
  }
  alike.push_back(static_cast<std::uint32_t>(matrices.size()));
  matrices.push_back(std::move(m));
  return alike.back();
}

/// A leaf that stands in one place twice is one mesh.
void Gather::stand(const Shapes::Shape& s, Open o) {
  const auto [at, fresh] =
      places_.try_emplace({s.leaf, o.matrix}, static_cast<std::uint32_t>(leaves.size()));
  const auto n = static_cast<std::uint32_t>(formula.nodes.size());
  formula.nodes.push_back({Formula::Kind::Mesh, at->second, {}});
  formula.nodes[o.parent].children.push_back(n);
  if (!fresh) return;
  PlacedMesh placed{s.leaf, o.matrix, s.tangled, s.open, s.from, {}};
  for (const Vec3& p : shapes_.leaves_[s.leaf].positions) {
    add_point(placed.box, matrices[o.matrix].nearest, {p.x, p.y, p.z});
  }
  leaves.push_back(placed);
}

void Gather::find_first() {
  for (std::uint32_t i = 0; i < children.size(); ++i) {
    if (children[i].within == kNothing) continue;
    std::uint32_t& first = unions[children[i].within].first;
    first = std::min(first, i);
  }
  for (std::size_t u = unions.size(); u-- > 0;) {
    if (unions[u].parent == kNothing) continue;
    std::uint32_t& first = unions[unions[u].parent].first;
    first = std::min(first, unions[u].first);
  }
}

}  // namespace burin::csg
