#include "boolean.h"

#include <burin/base/disjoint_sets.h>

#include "arrange.h"
#include "balance.h"
#include "cull.h"
#include "inside.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace burin::csg {
namespace {

using Kind = Formula::Kind;

/// For every node a box of what it can be, and for every mesh one of where it matters.
struct Boxes {
  std::vector<Box3> of_node, relevant;

  Boxes(const Formula& formula, std::span<const Mesh> meshes)
      : of_node(boxes_of(formula, meshes)), relevant(meshes.size()) {
    const auto& nodes = formula.nodes;
    std::vector<Box3> matters(nodes.size());
    matters[0] = of_node[0];
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      if (nodes[n].kind == Kind::Mesh) relevant[nodes[n].mesh].add(matters[n]);
      // What is cut off, and what all have in common, lies in this node's own box.
      const Box3 inner = nodes[n].kind == Kind::Union ? matters[n] : common(matters[n], of_node[n]);
      for (const std::uint32_t c : nodes[n].children) matters[c] = inner;
    }
  }
};

/// On which sides of a piece (bit 0: where the axis points, bit 1: the other) something is solid.
using Sides = unsigned;
constexpr Sides kBoth = 3;
// Facets to be cut from which on it pays to look for those that nobody sees; fewer take some tenths
// of a second.
constexpr std::size_t kManyFacets = 4000;

class Combiner {
 public:
  Combiner(Space& space, std::span<const Mesh> meshes, const Formula& formula,
           std::span<const char> through_points, RunContext& context,
           const std::function<void(double)>& share)
      : space_(space),
        meshes_(meshes),
        formula_(balanced(formula, boxes_of(formula, meshes))),
        context_(context),
        share_(share),
        through_points_(through_points),
        boxes_(formula_, meshes),
        known_(meshes.size()),
        known_at_(meshes.size(), 0) {
    for (const Mesh& m : meshes) inside_.emplace_back(space, m);
  }

  Mesh run() {
    std::size_t facets = 0;
    for (const Mesh& m : meshes_) facets += m.facets.size();
    if (facets >= kManyFacets) culled_ = cull(space_, meshes_, formula_, context_);
    list();
    pair();
    Mesh out;
    std::size_t done = 0;
    for (auto& [first, work] : sheets_) {
      if (++done % 16 == 0) {
        context_.check();
        share_(0.5 + 0.5 * static_cast<double>(done) / static_cast<double>(sheets_.size()));
      }
      judge(work, out.facets);
    }
    for (Facet& f : out.facets) {
      if (f.surface >= 0 && dropped_.contains(f.surface)) f.surface = -1;
    }
    find_boxes(space_, out);
    return out;
  }

 private:
  struct Work {
    Sheet sheet;
    std::vector<std::uint32_t> mesh;
  };

  void list() {
    for (std::uint32_t m = 0; m < meshes_.size(); ++m) {
      if (is_gone(m)) continue;
      for (std::uint32_t f = 0; f < meshes_[m].facets.size(); ++f) {
        if (!culled_.hidden.empty() && culled_.hidden[m][f]) continue;
        const Box3& box = meshes_[m].facets[f].box;
        if (box.overlaps(boxes_.relevant[m])) facets_.push_back({m, f, box});
      }
    }
  }
  bool is_gone(std::uint32_t m) const { return !culled_.gone.empty() && culled_.gone[m]; }
  const Facet& facet(std::uint32_t i) const {
    return meshes_[facets_[i].mesh].facets[facets_[i].facet];
  }

  void pair() {
    std::vector<char> tangled;
    for (const Mesh& m : meshes_) tangled.push_back(m.tangled ? 1 : 0);
    const auto pairs = overlapping(facets_, tangled, context_);
    DisjointSets sets(facets_.size());
    struct Met {
      std::uint32_t facet;
      Meeting meeting;
    };
    std::vector<Met> met;
    std::vector<Meeting> found;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (p % 256 == 0) {
        context_.check();
        share_(0.5 * static_cast<double>(p) / static_cast<double>(pairs.size()));
      }
      const auto [i, j] = pairs[p];
      const Facet &f = facet(i), &g = facet(j);
      if (f.plane == g.plane) {
        sets.join(i, j);
        continue;
      }
      found.clear();
      meet_facets(space_, f, g, found);
      if (!found.empty()) drop_grazing(f, g, found);
      for (const Meeting& m : found) {
        met.push_back({i, m});
        met.push_back({j, m});
      }
    }
    for (std::uint32_t i = 0; i < facets_.size(); ++i) {
      Work& work = sheets_[sets.find(i)];
      work.sheet.plane = facet(i).plane;
      work.sheet.facets.push_back(&facet(i));
      work.mesh.push_back(facets_[i].mesh);
    }
    for (const Met& m : met) sheets_[sets.find(m.facet)].sheet.meetings.push_back(m.meeting);
    for (auto& [first, work] : sheets_) {
      auto& list = work.sheet.meetings;
      const auto key = [](const Meeting& m) { return std::minmax(m.a, m.b); };
      std::ranges::sort(list, {}, key);
      const auto same = [&](const Meeting& m, const Meeting& n) { return key(m) == key(n); };
      list.erase(std::unique(list.begin(), list.end(), same), list.end());
    }
  }

  bool through_points(const Facet& f) const {
    return f.surface >= 0 && through_points_[static_cast<std::size_t>(f.surface)] != 0;
  }

  /// Drops smooth surfaces of two facets that cross at a small angle.
  void drop_grazing(const Facet& f, const Facet& g, std::span<const Meeting> found) {
    if (!through_points(f) && !through_points(g)) return;
    const Vec3 m = space_.normal(f.plane), n = space_.normal(g.plane);
    if (std::abs(glm::dot(m, n)) < kGrazing * glm::length(m) * glm::length(n)) return;
    if (std::ranges::all_of(found, [](const Meeting& w) { return w.a == w.b; })) return;
    if (neighbors(f, g)) return;
    if (through_points(f)) dropped_.insert(f.surface);
    if (through_points(g)) dropped_.insert(g.surface);
  }

  static bool neighbors(const Facet& f, const Facet& g) {
    return std::ranges::any_of(f.edges, [&](const Edge& e) {
      return std::ranges::any_of(g.edges, [&](const Edge& o) { return o.a == e.a; });
    });
  }

  void judge(const Work& work, std::vector<Facet>& out) {
    const Judge judge = [&](const std::array<Id, 3>& triangle,
                            std::span<const std::uint32_t> covering) {
      return piece(work, triangle, covering);
    };
    std::array<Id, 3> triangle{};
    if (work.sheet.facets.size() > 1 || !work.sheet.meetings.empty() ||
        !triangle_of(*work.sheet.facets[0], triangle)) {
      arrange(space_, work.sheet, judge, out);
      return;
    }
    const std::array<std::uint32_t, 1> one{0};
    const Piece p = judge(triangle, one);
    if (p.way == 0) return;
    Facet facet = *work.sheet.facets[0];
    if ((p.way > 0) != facet.along) {
      facet.along = !facet.along;
      for (Edge& e : facet.edges) std::swap(e.a, e.b);
    }
    out.push_back(std::move(facet));
  }

  /// A triangle of a facet that is one, or a convex quadrangle.
  bool triangle_of(const Facet& f, std::array<Id, 3>& out) {
    const std::size_t n = f.edges.size();
    if (n > 4) return false;
    std::array<Id, 4> loop{f.edges[0].a, f.edges[0].b, 0, 0};
    for (std::size_t k = 2; k < n; ++k) {
      const auto next = std::ranges::find(f.edges, loop[k - 1], &Edge::a);
      if (next == f.edges.end()) return false;
      loop[k] = next->b;
    }
    for (std::size_t k = 0; k < n && n == 4; ++k) {
      const int t = space_.turn(f.plane, loop[k], loop[(k + 1) % 4], loop[(k + 2) % 4]);
      if (t == 0 || t != space_.turn(f.plane, loop[0], loop[1], loop[2])) return false;
    }
    out = {loop[0], loop[1], loop[2]};
    return true;
  }

  Piece piece(const Work& work, const std::array<Id, 3>& triangle,
              std::span<const std::uint32_t> covering) {
    Sample sample(space_, work.sheet.plane, triangle);
    ++stamp_;
    const bool up = space_.normal(work.sheet.plane)[sample.axis] > 0;
    for (std::size_t k = 0; k < covering.size();) {
      const std::uint32_t m = work.mesh[covering[k]];
      std::size_t end = k;
      while (end < covering.size() && work.mesh[covering[end]] == m) ++end;
      if (end == k + 1 && !meshes_[m].tangled) {
        know(m, work.sheet.facets[covering[k]]->along == up ? 2 : 1);
      } else {
        const Sides above = inside_[m].odd(sample) ? 1 : 0;
        know(m, above | ((above ^ ((end - k) % 2)) << 1));
      }
      k = end;
    }
    const Sides s = sides(0, sample);
    if (s == 0 || s == kBoth) return {};
    Piece out;
    out.way = (s == 2) == up ? 1 : -1;
    const Facet* chosen = nullptr;
    for (const std::uint32_t c : covering) {
      const Facet* f = work.sheet.facets[c];
      if (!chosen || (chosen->along != (out.way > 0) && f->along == (out.way > 0))) chosen = f;
    }
    out.surface = chosen->surface;
    return out;
  }

  void know(std::uint32_t mesh, Sides s) {
    known_[mesh] = s;
    known_at_[mesh] = stamp_;
  }

  Sides sides(std::uint32_t n, Sample& sample) {
    const Formula::Node& node = formula_.nodes[n];
    if (node.kind == Kind::Mesh) return of_mesh(node.mesh, sample);
    const Box3& box = boxes_.of_node[n];
    if (!near(box, sample)) return 0;
    Sides out = node.kind == Kind::Intersection ? kBoth : 0;
    for (std::size_t c = 0; c < node.children.size(); ++c) {
      const bool cut = node.kind == Kind::Difference && c > 0;
      if (node.kind != Kind::Union && c > 0 && out == 0) break;
      if (node.kind == Kind::Union && out == kBoth) break;
      const Sides child = sides(node.children[c], sample);
      if (cut) {
        out &= ~child;
      } else if (node.kind == Kind::Intersection) {
        out &= child;
      } else {
        out |= child;
      }
    }
    return out & kBoth;
  }
  bool near(const Box3& box, const Sample& sample) const {
    const double e = std::min(sample.error, 1e-9 * space_.size());
    return box.overlaps({sample.at - Vec3(e), sample.at + Vec3(e)});
  }
  Sides of_mesh(std::uint32_t m, Sample& sample) {
    if (known_at_[m] == stamp_) return known_[m];
    Sides s = 0;
    if (!is_gone(m) && near(meshes_[m].box, sample) && inside_[m].odd(sample)) s = kBoth;
    know(m, s);
    return s;
  }

  Space& space_;
  std::span<const Mesh> meshes_;
  const Formula formula_;
  RunContext& context_;
  const std::function<void(double)>& share_;
  std::span<const char> through_points_;
  std::set<std::int32_t> dropped_;
  Boxes boxes_;
  std::vector<Inside> inside_;
  Culled culled_;
  std::vector<FacetBox> facets_;
  std::map<std::uint32_t, Work> sheets_;
  std::vector<Sides> known_;
  std::vector<std::size_t> known_at_;
  std::size_t stamp_ = 0;
};

}  // namespace

Mesh combine(Space& space, std::span<const Mesh> meshes, const Formula& formula,
             std::span<const char> through_points, RunContext& context,
             const std::function<void(double)>& share) {
  Mesh out = Combiner(space, meshes, formula, through_points, context, share).run();
  straighten(space, out);
  return out;
}

}  // namespace burin::csg
