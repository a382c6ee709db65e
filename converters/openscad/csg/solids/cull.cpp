#include "cull.h"

#include <algorithm>
#include <numeric>

namespace burin::csg {
namespace {

using Kind = Formula::Kind;

// Sides of planes that are asked for, a facet: as many as one meeting of two facets costs, several
// times over.
constexpr std::size_t kTestsPerFacet = 2000;
// An exact side costs as much as so many of doubles.
constexpr std::size_t kExactTests = 100;

/// Where the meshes are in a formula.
class MeshesInFormula {
 public:
  MeshesInFormula(const Formula& formula, std::size_t meshes)
      : nodes_(formula.nodes), parent_(nodes_.size(), 0), node_(meshes, 0), uses_(meshes, 0) {
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
      for (const std::uint32_t c : nodes_[n].children) parent_[c] = n;
      if (nodes_[n].kind == Kind::Mesh && uses_[nodes_[n].mesh]++ == 0) node_[nodes_[n].mesh] = n;
    }
    for (std::size_t m = 0; m < meshes; ++m) {
      top_.push_back(uses_[m] == 0 ? 0 : top_of(node_[m]));
      const std::uint32_t above = parent_[top_[m]];
      const bool cuts = above != top_[m] && nodes_[above].kind == Kind::Difference &&
                        nodes_[above].children.front() != top_[m];
      rules_.push_back(cuts ? above : top_[m]);
    }
  }

  bool once(std::uint32_t mesh) const { return uses_[mesh] == 1; }
  bool united(std::uint32_t a, std::uint32_t b) const { return top_[a] == top_[b]; }
  /// Whether what a mesh is does not matter where `other` is solid.
  bool decided_by(std::uint32_t mesh, std::uint32_t other) const {
    if (united(mesh, other)) return true;
    for (std::uint32_t n = node_[mesh]; n != 0; n = parent_[n]) {
      if (n == rules_[other]) return true;
    }
    return rules_[other] == 0;
  }

 private:
  /// The outermost of the unions that a node is directly in.
  std::uint32_t top_of(std::uint32_t n) const {
    while (n != 0 && nodes_[parent_[n]].kind == Kind::Union) n = parent_[n];
    return n;
  }

  const std::vector<Formula::Node>& nodes_;
  std::vector<std::uint32_t> parent_, node_, uses_, top_, rules_;
};

class Culler {
 public:
  Culler(Space& space, std::span<const Mesh> meshes, const Formula& formula, RunContext& context)
      : space_(space), meshes_(meshes), in_formula_(formula, meshes.size()), context_(context) {
    out_.gone.assign(meshes.size(), 0);
    for (const Mesh& m : meshes) {
      context.check();
      out_.hidden.emplace_back(m.facets.size(), 0);
      tests_ += kTestsPerFacet * m.facets.size();
      shapes_.push_back(shape_of(m));
    }
  }

  Culled run() {
    std::vector<std::uint32_t> order(meshes_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::erase_if(order, [&](std::uint32_t m) { return meshes_[m].facets.empty(); });
    const auto box = [&](std::size_t k) -> const Box3& { return meshes_[order[k]].box; };
    std::ranges::stable_sort(order, {}, [&](std::uint32_t m) { return meshes_[m].box.min.x; });
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (std::size_t l = k + 1; l < order.size() && box(l).min.x <= box(k).max.x; ++l) {
        if (l % 64 == 0) context_.check();
        if (!box(k).overlaps(box(l))) continue;
        look(order[k], order[l]);
        look(order[l], order[k]);
        if (tests_ == 0) return std::move(out_);
      }
    }
    return std::move(out_);
  }

 private:
  struct Shape {
    std::vector<Id> corners;
    /// For each facet the places of its corners in that list.
    std::vector<std::vector<std::uint32_t>> of_facet;
    /// A ball in the kernel, which is what lies behind the planes of all facets: it holds no point
    /// of the surface, and sees all of it from inside. A convex mesh is its own kernel. Radius 0:
    /// there is none.
    Vec3 middle{0};
    double radius = 0;
    /// Of its facets, sorted.
    std::vector<Id> planes;
    /// The facet that the last point was outside of.
    std::size_t last = 0;
  };

  Shape shape_of(const Mesh& mesh) {
    Shape out;
    for (const Facet& f : mesh.facets) {
      for (const Edge& e : f.edges) out.corners.push_back(e.a);
    }
    std::ranges::sort(out.corners);
    out.corners.erase(std::unique(out.corners.begin(), out.corners.end()), out.corners.end());
    for (const Facet& f : mesh.facets) {
      auto& list = out.of_facet.emplace_back();
      for (const Edge& e : f.edges) {
        list.push_back(static_cast<std::uint32_t>(std::ranges::lower_bound(out.corners, e.a) -
                                                  out.corners.begin()));
      }
    }
    if (mesh.tangled || mesh.facets.empty()) return out;
    for (const Id c : out.corners) {
      out.middle += space_.at(c) / static_cast<double>(out.corners.size());
    }
    out.radius = mesh.box.diagonal();
    for (const Facet& f : mesh.facets) {
      out.planes.push_back(f.plane);
      const auto [s, bound] = space_.distance(f.plane, out.middle);
      out.radius = std::min(out.radius, (f.along ? -s : s) - bound);
    }
    std::ranges::sort(out.planes);
    out.radius = std::max(0.0, out.radius * (1 - 1e-9));  // the distance to the middle is rounded
    return out;
  }

  /// 1 outside of a facet's plane, -1 inside, 0 where doubles are not sure.
  int rough_side(const Facet& f, Vec3 at, double error) const {
    const auto [s, bound] = space_.distance(f.plane, at);
    if (!(std::abs(s) > bound + 2 * error)) return 0;
    return (s > 0) == f.along ? 1 : -1;
  }
  int exact_side(const Facet& f, Id corner) {
    take(kExactTests);
    return f.along ? space_.side(corner, f.plane) : -space_.side(corner, f.plane);
  }

  /// What of `mesh` lies in the kernel of `other`.
  void look(std::uint32_t mesh, std::uint32_t other) {
    if (shapes_[other].radius == 0 || out_.gone[mesh] || !in_formula_.once(mesh)) return;
    if (!in_formula_.decided_by(mesh, other)) return;
    if (in_formula_.united(mesh, other) && lies_in(mesh, other) &&
        (mesh > other || shapes_[mesh].radius == 0 || !lies_in(other, mesh))) {
      out_.gone[mesh] = 1;
      return;
    }
    hide(mesh, other);
  }

  /// Whether a mesh lies in the kernel of another, or on its surface.
  bool lies_in(std::uint32_t mesh, std::uint32_t other) {
    const Box3 &a = meshes_[mesh].box, &b = meshes_[other].box;
    const double e = 1e-9 * space_.size();
    for (int i = 0; i < 3; ++i) {
      if (a.min[i] < b.min[i] - e || a.max[i] > b.max[i] + e) return false;
    }
    return std::ranges::all_of(shapes_[mesh].corners, [&](Id c) {
      return lies_in(c, shapes_[other], meshes_[other].facets);
    });
  }

  /// The same of a corner.
  bool lies_in(Id corner, Shape& shape, const std::vector<Facet>& facets) {
    if (in_ball(shape, corner)) return true;
    const Vec3 at = space_.at(corner);
    const double error = space_.error(corner);
    take(1);
    if (rough_side(facets[shape.last], at, error) > 0) return false;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      const int s = rough_side(facets[f], at, error);
      if (s < 0 || (s == 0 && exact_side(facets[f], corner) <= 0)) continue;
      take(f);
      shape.last = f;
      return false;
    }
    take(facets.size());
    return true;
  }

  bool in_ball(const Shape& shape, Id corner) const {
    return glm::distance(space_.at(corner), shape.middle) + 2 * space_.error(corner) < shape.radius;
  }

  /// A facet whose corners all lie in a kernel lies within it but for its border, unless both have
  /// a plane in common.
  void hide(std::uint32_t mesh, std::uint32_t other) {
    Box3 box = meshes_[other].box;
    const Vec3 e(1e-9 * space_.size());
    box = {box.min - e, box.max + e};
    const Shape& shape = shapes_[mesh];
    inside_.assign(shape.corners.size(), -1);
    for (std::size_t f = 0; f < shape.of_facet.size() && tests_ > 0; ++f) {
      const Facet& facet = meshes_[mesh].facets[f];
      if (out_.hidden[mesh][f] || !box.contains(facet.box.min) || !box.contains(facet.box.max) ||
          std::ranges::binary_search(shapes_[other].planes, facet.plane)) {
        continue;
      }
      out_.hidden[mesh][f] = std::ranges::all_of(shape.of_facet[f], [&](std::uint32_t c) {
        if (inside_[c] < 0) {
          inside_[c] = lies_in(shape.corners[c], shapes_[other], meshes_[other].facets) ? 1 : 0;
        }
        return inside_[c] == 1;
      });
    }
  }

  void take(std::size_t tests) { tests_ -= std::min(tests, tests_); }

  Space& space_;
  std::span<const Mesh> meshes_;
  const MeshesInFormula in_formula_;
  RunContext& context_;
  std::vector<Shape> shapes_;
  std::vector<std::int8_t> inside_;
  std::size_t tests_ = 0;
  Culled out_;
};

}  // namespace

Culled cull(Space& space, std::span<const Mesh> meshes, const Formula& formula,
            RunContext& context) {
  return Culler(space, meshes, formula, context).run();
}

}  // namespace burin::csg
