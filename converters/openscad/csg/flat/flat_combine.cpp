#include "at_node.h"
#include "clip.h"
#include "flat.h"
#include "fragments.h"
#include "origins.h"
#include "transform.h"

#include <algorithm>
#include <cmath>

namespace burin::csg {
namespace {

Region united(std::span<const Region> children) {
  if (children.size() == 1) return children[0];
  return clip(ClipOp::Union, children);
}

/// An empty first child, or any empty one of an intersection, leaves nothing.
Region difference_or_intersection(ClipOp op, std::span<const Region> children) {
  if (children.empty() || children[0].empty()) return {};
  if (children.size() == 1) return children[0];
  if (op == ClipOp::Intersection && std::ranges::any_of(children, &Region::empty)) return {};
  return clip(op, children);
}

Region minkowski(std::span<const Region> children) {
  if (children.empty() || children[0].empty()) return {};
  if (children.size() == 1) return children[0];
  // Empty ones are left out, but one must remain to be added.
  Region sum = children[0];
  bool added = false;
  for (const Region& child : children.subspan(1)) {
    if (child.empty()) continue;
    sum = minkowski_sum(sum, child);
    added = true;
  }
  return added ? sum : Region{};
}

Region offset(const Node& node, const Region& region) {
  const bool round = node.argument("r") != nullptr;
  const double delta = node.number(round ? "r" : "delta", 1);
  if (!std::isfinite(delta)) throw InputError("offset() by a distance that is no finite number");
  if (region.empty()) return {};
  if (delta == 0) return region;
  OffsetRule rule;
  rule.corner = round                          ? OffsetRule::Corner::Round
                : node.truth("chamfer", false) ? OffsetRule::Corner::Cut
                                               : OffsetRule::Corner::Sharp;
  rule.fragments = fragments(std::abs(delta), fineness_of(node));
  rule.tolerance = std::abs(delta) * (1 - std::cos(M_PI / rule.fragments));
  return offset_region(region, delta, rule);
}

bool finite_matrix(const Node& node) {
  if (node.arguments.empty()) return true;
  for (const Value& row : node.arguments[0].value.list) {
    for (const Value& v : row.list) {
      if (v.kind == Value::Kind::Number && !std::isfinite(v.number)) return false;
    }
  }
  return true;
}

Region moved(Evaluation& e, std::uint32_t node, const Region& region) {
  if (!finite_matrix(e.tree.nodes[node])) {
    report(e, node, "openscad.not_finite",
           "a transformation with numbers that are infinite or none; what it moves is left out");
    return {};
  }
  const Matrix m = matrix_of(e.tree, node);
  const Affine affine{
      {m.row[0][0], m.row[1][0]}, {m.row[0][1], m.row[1][1]}, {m.row[0][3], m.row[1][3]}};
  if (affine.determinant() == 0) {
    if (!region.empty()) {
      report(e, node, "openscad.scaled_to_nothing",
             "a 2-D object scaled to nothing; it is left out");
    }
    return {};
  }
  return transformed(region, affine);
}

/// OpenSCAD's rule: sizes of 0 stay as they are, or follow the largest one asked for.
Region resized(const Node& node, const Region& region) {
  if (region.empty()) return {};
  Vec2 low(INFINITY), high(-INFINITY);
  for (const Outline& o : region.outlines) {
    for (const Vec2& p : o.points) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  std::vector<double> size = node.numbers("newsize"), follow = node.numbers("auto");
  size.resize(3, 0);
  follow.resize(3, 0);
  const Vec2 now = high - low;
  const int largest = size[1] != 0 && size[1] > size[0] ? 1 : 0;
  const double common = size[static_cast<std::size_t>(largest)] > 0
                            ? size[static_cast<std::size_t>(largest)] / now[largest]
                            : 1;
  Vec2 scale(1);
  for (int k = 0; k < 2; ++k) {
    const auto i = static_cast<std::size_t>(k);
    if (size[i] > 0)
      scale[k] = size[i] / now[k];
    else if (follow[i] != 0)
      scale[k] = common;
  }
  return transformed(region, {{scale.x, 0}, {0, scale.y}, Vec2(0)});
}

Region combined(Evaluation& e, std::uint32_t at, std::span<const Region> children) {
  const Node& node = e.tree.nodes[at];
  switch (node.module) {
    case Module::Difference:
      return difference_or_intersection(ClipOp::Difference, children);
    case Module::Intersection:
      return difference_or_intersection(ClipOp::Intersection, children);
    case Module::Minkowski:
      return minkowski(children);
    case Module::Hull:
      return hull_of(children);
    case Module::Offset:
      return offset(node, united(children));
    case Module::Multmatrix:
      return moved(e, at, united(children));
    case Module::Resize:
      return resized(node, united(children));
    default:
      return united(children);
  }
}

}  // namespace

Region combine_regions(Evaluation& e, std::uint32_t node, std::span<const Region> children) {
  e.run.check();
  if (children.empty()) return {};
  return at_node(e, node, [&] { return combined(e, node, children); });
}

}  // namespace burin::csg
