#include "balance.h"

#include <algorithm>
#include <utility>

namespace burin::csg {
namespace {

// Children that are looked at one by one: a node of their own costs as much as a few boxes.
constexpr std::size_t kFew = 4;

using Kind = Formula::Kind;

/// Of what is nothing too: open polyhedra are left out of cuts.
Vec3 middle(const Box3& b) { return b.empty() ? Vec3(0) : b.center(); }

class Balancer {
 public:
  Balancer(const Formula& whole, std::span<const Box3> box) : whole_(whole), box_(box) {}

  Formula run() {
    add(0);
    while (!open_.empty()) {
      auto [node, children] = std::move(open_.back());
      open_.pop_back();
      if (out_.nodes[node].kind == Kind::Union && children.size() > kFew) {
        split(node, std::move(children));
        continue;
      }
      for (const std::uint32_t c : children) {
        const std::uint32_t n = add(c);  // before the list of its parent is looked up: nodes move
        out_.nodes[node].children.push_back(n);
      }
    }
    return std::move(out_);
  }

 private:
  struct Open {
    std::uint32_t node;
    /// Of the whole formula.
    std::vector<std::uint32_t> children;
  };

  std::uint32_t node(Kind kind, std::uint32_t mesh, std::vector<std::uint32_t> children) {
    const auto n = static_cast<std::uint32_t>(out_.nodes.size());
    out_.nodes.push_back({kind, mesh, {}});
    if (!children.empty()) open_.push_back({n, std::move(children)});
    return n;
  }
  std::uint32_t add(std::uint32_t from) {
    const Formula::Node& n = whole_.nodes[from];
    return node(n.kind, n.mesh, n.children);
  }

  /// Two halves along the axis on which the middles of the children are farthest apart.
  void split(std::uint32_t parent, std::vector<std::uint32_t> children) {
    Box3 middles;
    for (const std::uint32_t c : children) middles.add(middle(box_[c]));
    const Vec3 size = middles.size();
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto half = children.begin() + static_cast<std::ptrdiff_t>(children.size() / 2);
    std::nth_element(children.begin(), half, children.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(middle(box_[a])[axis], a) < std::pair(middle(box_[b])[axis], b);
    });
    const auto add_half = [&](auto from, auto to) {
      const std::uint32_t n = node(Kind::Union, 0, std::vector(from, to));
      out_.nodes[parent].children.push_back(n);
    };
    add_half(children.begin(), half);
    add_half(half, children.end());
  }

  const Formula& whole_;
  std::span<const Box3> box_;
  Formula out_;
  std::vector<Open> open_;
};

}  // namespace

std::vector<Box3> boxes_of(const Formula& formula, std::span<const Mesh> meshes) {
  const auto& nodes = formula.nodes;
  std::vector<Box3> box(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 0;) {
    if (nodes[n].kind == Kind::Mesh) box[n] = meshes[nodes[n].mesh].box;
    for (std::size_t c = 0; c < nodes[n].children.size(); ++c) {
      const Box3& child = box[nodes[n].children[c]];
      if (c == 0) {
        box[n] = child;
      } else if (nodes[n].kind == Kind::Union) {
        box[n].add(child);
      } else if (nodes[n].kind == Kind::Intersection) {
        box[n] = common(box[n], child);
      }
    }
  }
  return box;
}

Formula balanced(const Formula& whole, std::span<const Box3> box) {
  return Balancer(whole, box).run();
}

}  // namespace burin::csg
