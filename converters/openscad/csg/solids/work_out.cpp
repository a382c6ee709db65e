#include <burin/base/disjoint_sets.h>
#include <burin/base/parallel.h>

#include "alike.h"
#include "gather.h"
#include "primitives.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace burin::csg {
namespace {

// Triangles of the solids of a program that are to be cut. Below, all is cut where it stands, in a
// few tenths of a second; above, what is alike is cut once, and its copies are a rounding away.
constexpr std::size_t kManyTriangles = 20'000;
// Triangles of results that are kept for others that are alike: half a gigabyte.
constexpr std::size_t kMostKept = 4'000'000;

double largest_bound(const Box3& b) {
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

/// Some children of a formula's root with all below them, on their own.
Formula excerpt(const Formula& whole, std::span<const std::uint32_t> children,
                std::vector<std::uint32_t>& meshes) {
  Formula out;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  out.nodes.push_back({Formula::Kind::Union, 0, {}});
  struct Open {
    std::uint32_t from, parent;
  };
  std::vector<Open> open;
  for (const std::uint32_t c : children) open.push_back({whole.nodes[0].children[c], 0});
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

/// Which children of the root belong together, by their places in its list: their boxes overlap.
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
  for (std::uint32_t i = 0; i < children.size(); ++i) by_set[sets.find(i)].push_back(i);
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

/// For every node below the root a box that holds it.
std::vector<Box3> boxes_of(const Gather& all) {
  const auto& nodes = all.formula.nodes;
  std::vector<Box3> box(nodes.size());
  for (std::size_t n = nodes.size(); n-- > 1;) {
    if (nodes[n].kind == Formula::Kind::Mesh) box[n] = all.leaves[nodes[n].mesh].box;
    for (const std::uint32_t c : nodes[n].children) {
      box[n].add(box[c]);
      if (nodes[n].kind == Formula::Kind::Difference) break;
    }
  }
  return box;
}

}  // namespace

/// One shape on its way to triangles: what touches is cut together, what is apart stays so.
class WorkOut {
 public:
  WorkOut(Shapes& shapes, const Gather& all, bool clean, RunContext& context,
          const std::function<void(double)>& share)
      : shapes_(shapes), all_(all), clean_(clean), context_(context), share_(share) {}

  Solid run() {
    const std::vector<Box3> box = boxes_of(all_);
    for (const auto& children : groups(all_.formula, box)) plan(children);
    share_alike();
    shapes_.doing = fmt::format("cutting {} solids of {} triangles", solids_, cost_);
    parallel_for(
        cuts_.size(), 1, [&](std::size_t from, std::size_t) { cut(from); }, &context_);
    shapes_.cuts += cuts_.size();
    return joined();
  }

 private:
  /// Solids that touch, to be cut together.
  struct Cut {
    Formula formula;
    std::vector<std::uint32_t> leaves;
    Alike alike;
    /// Triangles of its leaves, and the part that is done.
    std::size_t cost = 0;
    double done = 0;
    Solid solid;
  };
  /// Where a piece of the result comes from: a leaf as it is, or a cut.
  struct Piece {
    std::uint32_t leaf = kNothing;
    std::size_t cut = 0;
    /// Another one that is alike, and how that has to be moved.
    std::shared_ptr<const Solid> other;
    Matrix by;
  };

  void plan(const std::vector<std::uint32_t>& children) {
    std::vector<std::uint32_t> leaves;
    Formula formula = excerpt(all_.formula, children, leaves);
    if (leaves.size() == 1 && alone(formula) && !(clean_ && all_.leaves[leaves[0]].tangled)) {
      pieces_.push_back({leaves[0], 0, {}, {}});
      return;
    }
    Cut cut{std::move(formula), std::move(leaves), alike(all_, children), 0, 0, {}};
    for (const std::uint32_t l : cut.leaves) {
      cut.cost += shapes_.leaves_[all_.leaves[l].leaf].triangles.size();
      if (all_.leaves[l].open) shapes_.left_out.push_back(all_.leaves[l].from);
    }
    pieces_.push_back({kNothing, cuts_.size(), {}, {}});
    cuts_.push_back(std::move(cut));
  }

  /// Cuts that are alike are made once.
  void share_alike() {
    for (const Cut& c : cuts_) cost_ += c.cost, solids_ += c.leaves.size();
    shapes_.to_cut_ += cost_;
    if (clean_ || shapes_.to_cut_ < kManyTriangles) return;
    std::map<std::vector<std::uint32_t>, std::size_t> first;
    std::vector<Cut> needed;
    for (Piece& piece : pieces_) {
      if (piece.leaf != kNothing) continue;
      Cut& cut = cuts_[piece.cut];
      const ExactMatrix& at = all_.matrices[cut.alike.matrix];
      if (const auto known = shapes_.known_.find(cut.alike.key); known != shapes_.known_.end()) {
        piece.other = known->second.solid;
        piece.by = multiply(at, inverse(known->second.at)).nearest;
        continue;
      }
      const auto [same, fresh] = first.try_emplace(cut.alike.key, needed.size());
      piece.cut = same->second;
      if (fresh) {
        needed.push_back(std::move(cut));
      } else {
        piece.by = multiply(at, inverse(all_.matrices[needed[piece.cut].alike.matrix])).nearest;
      }
    }
    cuts_ = std::move(needed);
  }

  void cut(std::size_t c) {
    Cut& cut = cuts_[c];
    double size = 0;
    for (const std::uint32_t s : cut.leaves)
      size = std::max(size, largest_bound(all_.leaves[s].box));
    Space space(size);
    std::vector<Turned> surfaces;
    std::vector<Mesh> meshes;
    for (const std::uint32_t s : cut.leaves) {
      context_.check();
      meshes.push_back(mesh_at(space, all_.leaves[s], surfaces));
    }
    std::vector<char> through_points;
    for (const Turned& t : surfaces) through_points.push_back(t.profile == Turned::Profile::Grid);
    const Mesh result = combine(space, meshes, cut.formula, through_points, context_,
                                [&](double s) { report(cut, s); });
    cut.solid = solid_of(space, result);
    cut.solid.surfaces = std::move(surfaces);
    report(cut, 1);
  }

  /// A leaf where it stands; its surfaces join those of the cut. Empty where it is open.
  Mesh mesh_at(Space& space, const Gather::PlacedMesh& leaf, std::vector<Turned>& surfaces) const {
    if (leaf.open) return {};
    const Solid& solid = shapes_.leaves_[leaf.leaf];
    const ExactMatrix& m = all_.matrices[leaf.matrix];
    std::vector<std::int32_t> numbers;
    for (const Turned& t : solid.surfaces) {
      const auto turned = csg::moved(t, m.nearest);
      numbers.push_back(turned ? static_cast<std::int32_t>(surfaces.size()) : -1);
      if (turned) surfaces.push_back(*turned);
    }
    return mesh_of(space, solid, space.add_matrix(m), m.nearest.determinant() < 0, numbers,
                   leaf.tangled);
  }

  /// From any thread.
  void report(Cut& cut, double share) {
    const std::lock_guard lock(telling_);
    done_ += (share - cut.done) * static_cast<double>(cut.cost);
    cut.done = share;
    share_(std::clamp(done_ / static_cast<double>(std::max<std::size_t>(cost_, 1)), 0.0, 1.0));
  }

  /// All pieces in their order. What was cut is kept for others that are alike.
  Solid joined() {
    std::vector<std::shared_ptr<const Solid>> solids;
    for (Cut& c : cuts_) {
      solids.push_back(std::make_shared<const Solid>(std::move(c.solid)));
      shapes_.kept_ += solids.back()->triangles.size();
      if (clean_ || shapes_.kept_ > kMostKept) continue;
      shapes_.known_.try_emplace(std::move(c.alike.key),
                                 Shapes::Known{solids.back(), all_.matrices[c.alike.matrix]});
    }
    Solid out;
    for (const Piece& piece : pieces_) {
      context_.check();
      if (piece.leaf != kNothing) {
        const Gather::PlacedMesh& leaf = all_.leaves[piece.leaf];
        append(out, csg::moved(shapes_.leaves_[leaf.leaf], all_.matrices[leaf.matrix].nearest));
        continue;
      }
      const Solid& solid = piece.other ? *piece.other : *solids[piece.cut];
      if (piece.by == Matrix{}) {
        append(out, solid);
      } else {
        append(out, csg::moved(solid, piece.by));
      }
    }
    compact(out);
    return out;
  }

  Shapes& shapes_;
  const Gather& all_;
  bool clean_;
  RunContext& context_;
  const std::function<void(double)>& share_;
  std::vector<Piece> pieces_;
  std::vector<Cut> cuts_;
  std::size_t cost_ = 0, solids_ = 0;
  std::mutex telling_;
  double done_ = 0;
};

Solid Shapes::solid(ShapeId root, RunContext& context, const std::function<void(double)>& share,
                    bool clean) {
  if (root == kNothing) return {};
  Gather all(*this);
  all.run(root);
  return WorkOut(*this, all, clean, context, share).run();
}

}  // namespace burin::csg
