#include "pieces.h"

#include <burin/base/disjoint_sets.h>

#include "specks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace burin {
namespace {

// Steps across the smaller pieces, at least.
constexpr double kStepsAcross = 10;
// Steps around a piece's box.
constexpr double kMargin = 1.5;
// Steps from a point of the surface to the nearest vertex of a mesh that has it there.
constexpr double kNear = 0.8;
// Steps of the whole mesh: larger components are not lost whole.
constexpr double kLarge = 6;

double longest(const Box3& b) {
  const Vec3 s = b.size();
  return std::max({s.x, s.y, s.z});
}

Box3 grown(const Box3& b, double by) { return {b.min - by, b.max + by}; }

bool meet(const Box3& a, const Box3& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.min[i] > b.max[i] || b.min[i] > a.max[i]) return false;
  }
  return true;
}

bool holds(const Box3& b, Vec3 p) {
  return glm::all(glm::lessThanEqual(b.min, p)) && glm::all(glm::lessThanEqual(p, b.max));
}

// The closed components of nets, each as nets of its own.
std::vector<Nets> closed_components(const Nets& nets) {
  DisjointSets sets(nets.vertices.size());
  std::unordered_set<std::uint64_t> edges;
  const auto ring = [&](std::size_t k) {
    return std::span(nets.corners)
        .subspan(nets.first_corner[k], nets.first_corner[k + 1] - nets.first_corner[k]);
  };
  const auto name = [](std::uint32_t u, std::uint32_t v) {
    return (static_cast<std::uint64_t>(u) << 32) | v;
  };
  const std::size_t polygons = nets.first_corner.empty() ? 0 : nets.first_corner.size() - 1;
  for (std::size_t k = 0; k < polygons; ++k) {
    const auto r = ring(k);
    for (std::size_t i = 0; i < r.size(); ++i) {
      sets.join(r[0], r[i]);
      edges.insert(name(r[i], r[(i + 1) % r.size()]));
    }
  }
  std::vector<std::uint8_t> open(nets.vertices.size(), 0);
  for (std::size_t k = 0; k < polygons; ++k) {
    const auto r = ring(k);
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (!edges.contains(name(r[(i + 1) % r.size()], r[i]))) open[sets.find(r[0])] = 1;
    }
  }
  std::map<std::uint32_t, std::size_t> number;
  std::vector<Nets> parts;
  std::vector<std::uint32_t> own(nets.vertices.size(), 0);
  std::vector<std::uint8_t> used(nets.vertices.size(), 0);
  for (const std::uint32_t c : nets.corners) used[c] = 1;
  for (std::uint32_t v = 0; v < nets.vertices.size(); ++v) {
    const std::uint32_t set = sets.find(v);
    if (!used[v] || open[set]) continue;
    const auto [it, fresh] = number.try_emplace(set, parts.size());
    if (fresh) parts.emplace_back().first_corner.push_back(0);
    Nets& part = parts[it->second];
    own[v] = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.push_back(nets.vertices[v]);
    part.sources.push_back(nets.sources[v]);
    // Those on faces between cells come last.
    if (v < nets.first_extra) part.first_extra = own[v] + 1;
  }
  for (std::size_t k = 0; k < polygons; ++k) {
    const auto r = ring(k);
    const auto it = number.find(sets.find(r[0]));
    if (it == number.end()) continue;
    Nets& part = parts[it->second];
    for (const std::uint32_t v : r) part.corners.push_back(own[v]);
    part.first_corner.push_back(static_cast<std::uint32_t>(part.corners.size()));
  }
  return parts;
}

Box3 box_of(const std::vector<Vec3>& points) {
  Box3 b;
  for (const Vec3& p : points) b.add(p);
  return b;
}

// Net by net onto the surface and its creases.
ExactMesh onto(const Survey& survey, Nets nets, const GridLayout& layout, WorkBudget& budget,
               const RunContext& context) {
  std::size_t strays = 0;
  ExactMesh mesh = project_nets(*survey.function, std::move(nets), layout, survey.mesh.size, budget,
                                strays, context);
  cut_along_creases(mesh, *survey.function, context);
  budget = mesh.budget;
  return mesh;
}

// The components that lie wholly in a box.
std::vector<ExactMesh> components_in(const Survey& survey, const Box3& box, double step,
                                     WorkBudget& budget, const RunContext& context) {
  const Grid grid(*survey.function, make_layout(box, step), budget, context);
  std::vector<ExactMesh> meshes;
  for (Nets& nets : closed_components(make_nets(grid, context))) {
    meshes.push_back(onto(survey, std::move(nets), grid.layout(), budget, context));
  }
  return meshes;
}

// Points by cubes of space.
class PointCells {
 public:
  PointCells(const std::vector<Vec3>& points, double side) : points_(points), side_(side) {
    for (std::uint32_t i = 0; i < points.size(); ++i) cells_[key(cell(points[i]))].push_back(i);
  }

  // Whether one is nearer than `side`.
  bool any_near(Vec3 p) const {
    const Cell middle = cell(p);
    for (int k = 0; k < 27; ++k) {
      const auto it = cells_.find(key(middle + Cell(k % 3, k / 3 % 3, k / 9) - 1));
      if (it == cells_.end()) continue;
      for (const std::uint32_t i : it->second) {
        if (glm::distance(points_[i], p) < side_) return true;
      }
    }
    return false;
  }

 private:
  Cell cell(Vec3 p) const { return Cell(glm::floor((p - points_.front()) / side_)); }
  static std::uint64_t key(Cell c) {
    const auto part = [](int v) { return static_cast<std::uint64_t>(v) & 0x1fffff; };
    return part(c.x) | (part(c.y) << 21) | (part(c.z) << 42);
  }

  const std::vector<Vec3>& points_;
  double side_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

double nearest(const ExactMesh& mesh, Vec3 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& q : mesh.positions) least = std::min(least, glm::distance(p, q));
  return least;
}

void append(ExactMesh& mesh, const ExactMesh& part) {
  const auto vertices = static_cast<std::uint32_t>(mesh.positions.size());
  const auto creases = static_cast<std::int32_t>(mesh.creases.size());
  if (mesh.spacing.empty()) mesh.spacing.assign(vertices, mesh.step);
  mesh.spacing.resize(vertices, mesh.step);
  mesh.spacing.insert(mesh.spacing.end(), part.positions.size(), part.step);
  const auto add = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(mesh.positions, part.positions);
  add(mesh.normals, part.normals);
  add(mesh.pieces, part.pieces);
  add(mesh.zero, part.zero);
  add(mesh.creases, part.creases);
  add(mesh.side, part.side);
  for (const std::int32_t c : part.crease) mesh.crease.push_back(c < 0 ? c : creases + c);
  for (Triangle t : part.triangles) {
    for (std::uint32_t& v : t) v += vertices;
    mesh.triangles.push_back(t);
  }
}

// One piece in triangles of about `step`: what lies in its box and comes nearest to its point.
std::optional<ExactMesh> mesh_piece(const Survey& survey, const Component& piece, double step,
                                    WorkBudget& budget, const RunContext& context) {
  std::vector<ExactMesh> meshes =
      components_in(survey, grown(piece.box, kMargin * step), step, budget, context);
  std::optional<ExactMesh> best;
  double least = 2 * step;
  for (ExactMesh& m : meshes) {
    const double d = nearest(m, piece.point);
    if (m.triangles.empty() || d >= least) continue;
    least = d;
    best = std::move(m);
  }
  return best;
}

// Cells of places that touch one another.
struct Cluster {
  std::vector<Cell> cells;
  Box3 box;
  double side = 0;  // of the largest place in a cell, the median of all cells
  std::vector<HiddenPlace> places;
};

std::vector<Cluster> clusters_of(const std::vector<HiddenPlace>& places) {
  struct InCell {
    Box3 box;
    double side = 0;
  };
  const auto before = [](const Cell& a, const Cell& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<Cell, InCell, decltype(before)> cells(before);
  for (const HiddenPlace& p : places) {
    InCell& c = cells[p.cell];
    c.box.add(p.box.min);
    c.box.add(p.box.max);
    c.side = std::max(c.side, longest(p.box));
  }
  std::map<Cell, std::uint32_t, decltype(before)> number(before);
  for (const auto& [cell, in] : cells) {
    number.emplace(cell, static_cast<std::uint32_t>(number.size()));
  }
  DisjointSets sets(cells.size());
  for (const auto& [cell, n] : number) {
    for (int k = 0; k < 27; ++k) {
      const auto it = number.find(cell + Cell(k % 3, k / 3 % 3, k / 9) - 1);
      if (it != number.end()) sets.join(n, it->second);
    }
  }
  std::map<std::uint32_t, Cluster> clusters;
  std::map<std::uint32_t, std::vector<double>> sides;
  for (const auto& [cell, in] : cells) {
    Cluster& c = clusters[sets.find(number.at(cell))];
    c.cells.push_back(cell);
    c.box.add(in.box.min);
    c.box.add(in.box.max);
    sides[sets.find(number.at(cell))].push_back(in.side);
  }
  for (const HiddenPlace& p : places) {
    clusters[sets.find(number.at(p.cell))].places.push_back(p);
  }
  std::vector<Cluster> out;
  for (auto& [name, c] : clusters) {
    std::vector<double>& s = sides[name];
    std::ranges::nth_element(s, s.begin() + static_cast<std::ptrdiff_t>(s.size() / 2));
    c.side = s[s.size() / 2];
    out.push_back(std::move(c));
  }
  return out;
}

}  // namespace

namespace {

// The share of the cells of a cluster that a mesh passes through.
double share_passed(const Cluster& cluster, const ExactMesh& mesh, const GridLayout& layout) {
  const auto name = [](Cell c) {
    return static_cast<std::uint64_t>(c.x) | (static_cast<std::uint64_t>(c.y) << 21) |
           (static_cast<std::uint64_t>(c.z) << 42);
  };
  std::unordered_set<std::uint64_t> passed;
  const Box3 around = grown(cluster.box, layout.step);
  for (const Vec3& p : mesh.positions) {
    if (holds(around, p)) passed.insert(name(layout.cell_of(p)));
  }
  const auto n =
      std::ranges::count_if(cluster.cells, [&](const Cell& c) { return passed.contains(name(c)); });
  return static_cast<double>(n) / static_cast<double>(cluster.cells.size());
}

// What the places of one look are, one cluster after the other.
class Finder {
 public:
  Finder(Survey& survey, const GridLayout& layout, WorkBudget& budget, const RunContext& context)
      : survey_(survey), layout_(layout), budget_(budget), context_(context), known_(survey.mesh) {}

  // The places of it that are in none of the components that were found, where any was.
  std::vector<HiddenPlace> add(const Cluster& cluster) {
    // Part of a wall as thin as a cell, which the look has in part.
    constexpr std::size_t kMany = 64;
    constexpr double kThin = 0.3;
    const double passed = share_passed(cluster, survey_.mesh, layout_);
    if (cluster.cells.size() > kMany && passed > kThin) return {};
    constexpr double kOfSide = 0.7, kOfCell = 0.25;
    const double step = std::min(kOfSide * cluster.side, kOfCell * layout_.step);
    Box3 around = grown(cluster.box, layout_.step);
    // A piece that leaves the box is longer than what was seen of it.
    constexpr int kEnlargements = 4;
    constexpr double kMostSteps = 4000;
    if (longest(around) > kMostSteps * step) throw TooMuchWork();
    for (int i = 0; i <= kEnlargements && longest(around) < kMostSteps * step; ++i) {
      std::vector<Box3> taken;
      for (const ExactMesh& m : components_in(survey_, around, step, budget_, context_)) {
        if (take(m, step)) taken.push_back(survey_.pieces.back().box);
      }
      if (!taken.empty()) return left_of(cluster, taken);
      if (i > 0 && passed > 0) break;
      around = grown(around, 0.5 * longest(around));
    }
    return {};
  }

 private:
  // A component of the look with less of the diagonal is a fragment.
  static constexpr double kFragment = 0.6;

  static std::vector<HiddenPlace> left_of(const Cluster& cluster, const std::vector<Box3>& taken) {
    std::vector<HiddenPlace> left;
    for (const HiddenPlace& p : cluster.places) {
      if (std::ranges::none_of(taken, [&](const Box3& b) { return meet(b, p.box); })) {
        left.push_back(p);
      }
    }
    return left;
  }

  bool is_taken(const Component& piece) const {
    return std::ranges::any_of(survey_.pieces, [&](const Component& p) {
      return holds(p.box, piece.box.center()) && holds(piece.box, p.box.center()) &&
             p.box.diagonal() > kFragment * piece.box.diagonal() &&
             piece.box.diagonal() > kFragment * p.box.diagonal();
    });
  }

  // Adds a component that the look has not, or has in fragments, which it replaces.
  bool take(const ExactMesh& m, double step) {
    if (m.triangles.empty()) return false;
    const Component piece{box_of(m.positions), m.positions.front(), step};
    if (is_taken(piece)) return false;
    const Box3 around = grown(piece.box, step);
    const PointCells near(m.positions, kNear * step);
    std::vector<std::uint8_t> fragment(survey_.mesh.positions.size(), 0);
    bool any = false;
    for (std::uint32_t v = 0; v < known_.boxes.size(); ++v) {
      const Vec3 p = survey_.mesh.positions[v];
      if (!holds(around, p) || !near.any_near(p)) continue;
      const std::uint32_t set = known_.sets.find(v);
      if (known_.boxes[set].diagonal() > kFragment * piece.box.diagonal()) return false;
      fragment[set] = 1;
      any = true;
    }
    if (any) {
      known_ = MeshComponents(survey_.mesh);
      drop_components(survey_.mesh, known_, fragment);
      known_ = MeshComponents(survey_.mesh);
    }
    const double own = std::min(step, longest(piece.box) / kStepsAcross);
    std::optional<ExactMesh> finer;
    if (own < step) finer = mesh_piece(survey_, piece, own, budget_, context_);
    append(survey_.mesh, finer ? *finer : m);
    survey_.pieces.push_back(piece);
    survey_.box.add(piece.box.min);
    survey_.box.add(piece.box.max);
    return true;
  }

  Survey& survey_;
  const GridLayout& layout_;
  WorkBudget& budget_;
  const RunContext& context_;
  MeshComponents known_;  // of what was there when it was made
};

}  // namespace

bool add_hidden_pieces(Survey& survey, const std::vector<HiddenPlace>& places,
                       const GridLayout& layout, WorkBudget& budget, const RunContext& context) {
  bool complete = true;
  // Each time fewer, so that it ends.
  std::vector<Cluster> clusters = clusters_of(places);
  Finder finder(survey, layout, budget, context);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    context.check();
    try {
      const auto left = finder.add(clusters[i]);
      if (left.empty()) continue;
      for (Cluster& c : clusters_of(left)) clusters.push_back(std::move(c));
    } catch (const TooMuchWork&) {
      complete = false;
    }
  }
  return complete;
}

double longest_unexplained(const Survey& survey, const std::vector<HiddenPlace>& places,
                           const GridLayout& layout) {
  constexpr double kExplained = 0.5;
  double most = 0;
  for (const Cluster& c : clusters_of(places)) {
    const double size = longest(c.box);
    if (size > most && share_passed(c, survey.mesh, layout) < kExplained) most = size;
  }
  return most;
}

namespace {

// The components of a first look beside those of a mesh made afterwards.
class Losses {
 public:
  Losses(ExactMesh& mesh, const Survey& survey)
      : mesh_(mesh), survey_(survey), expected_(survey.mesh), made_(mesh) {}

  // What is not there; what is there of it is left out.
  std::vector<Component> find() {
    std::vector<std::uint8_t> dropped(made_.boxes.size(), 0), lost(expected_.boxes.size(), 0);
    for (bool more = true; more;) {
      more = false;
      for (std::uint32_t e = 0; e < lost.size(); ++e) {
        if (lost[e] || expected_.boxes[e].empty() || is_there(e, dropped)) continue;
        lost[e] = 1;
        more = true;
        for (std::uint32_t m = 0; m < dropped.size(); ++m) {
          if (is_part(m, e)) dropped[m] = 1;
        }
      }
    }
    std::vector<Component> out;
    for (std::uint32_t e = 0; e < lost.size(); ++e) {
      if (!lost[e]) continue;
      out.push_back({expected_.boxes[e], survey_.mesh.positions[e], survey_.mesh.step_at(e)});
    }
    if (std::ranges::find(dropped, 1) != dropped.end()) drop_components(mesh_, made_, dropped);
    return out;
  }

 private:
  static constexpr double kSmallest = 0.3, kLargest = 1.5;  // shares of a component's diagonal

  bool is_large(const Box3& b) const { return b.diagonal() >= kLarge * mesh_.step; }

  bool is_there(std::uint32_t e, const std::vector<std::uint8_t>& dropped) {
    const Box3& box = expected_.boxes[e];
    if (is_large(box)) return has_point_near(survey_.mesh.positions[e]);
    for (std::uint32_t m = 0; m < dropped.size(); ++m) {
      if (dropped[m] || made_.boxes[m].empty()) continue;
      const double size = made_.boxes[m].diagonal();
      if (size < kSmallest * box.diagonal() || size > kLargest * box.diagonal()) continue;
      if (holds(box, made_.boxes[m].center())) return true;
    }
    return is_joined(e);
  }

  // Of a fragment, as grids leave of thin wires.
  bool is_part(std::uint32_t m, std::uint32_t e) const {
    const Box3 &part = made_.boxes[m], &box = expected_.boxes[e];
    return !part.empty() && !is_large(box) && part.diagonal() <= kLargest * box.diagonal() &&
           meet(part, box);
  }

  bool has_point_near(Vec3 p) const {
    constexpr double kReach = 1.5;
    return std::ranges::any_of(
        mesh_.positions, [&](const Vec3& q) { return glm::distance(p, q) < kReach * mesh_.step; });
  }

  // Whether it has become part of a larger one, which lies within a step of it.
  bool is_joined(std::uint32_t e) {
    const double near = kNear * survey_.mesh.step_at(e), size = expected_.boxes[e].diagonal();
    const Box3 around = grown(expected_.boxes[e], near);
    std::vector<Vec3> own;
    for (std::uint32_t v = 0; v < mesh_.positions.size(); ++v) {
      if (!holds(around, mesh_.positions[v])) continue;
      if (made_.boxes[made_.sets.find(v)].diagonal() <= kLargest * size) continue;
      if (own.empty()) {
        for (std::uint32_t u = 0; u < survey_.mesh.positions.size(); ++u) {
          if (expected_.sets.find(u) == e) own.push_back(survey_.mesh.positions[u]);
        }
      }
      const auto close = [&](const Vec3& q) { return glm::distance(mesh_.positions[v], q) < near; };
      if (std::ranges::any_of(own, close)) return true;
    }
    return false;
  }

  ExactMesh& mesh_;
  const Survey& survey_;
  MeshComponents expected_, made_;
};

}  // namespace

bool add_lost_pieces(ExactMesh& mesh, const Survey& survey, double tolerance,
                     const RunContext& context) {
  constexpr double kBudget = 2e9;        // nanoseconds of one core
  constexpr double kMostAcross = 60;     // steps
  constexpr double kEdgePerStep = 1.25;  // as in choose_step
  WorkBudget budget(kBudget);
  for (const Component& piece : Losses(mesh, survey).find()) {
    context.check();
    const double size = longest(piece.box);
    const double wanted = std::sqrt(4 * size * tolerance) / kEdgePerStep;
    const double step =
        std::min(piece.step, std::clamp(wanted, size / kMostAcross, size / kStepsAcross));
    try {
      if (auto part = mesh_piece(survey, piece, step, budget, context)) append(mesh, *part);
    } catch (const TooMuchWork&) {
      return false;
    }
  }
  return true;
}

}  // namespace burin
