#include "piece_mesh.h"

#include <burin/base/disjoint_sets.h>

#include "boxes.h"
#include "grid.h"
#include "surface_nets.h"

#include <algorithm>
#include <limits>
#include <map>
#include <span>
#include <unordered_set>

namespace burin {
namespace {

// Steps around a piece's box.
constexpr double kPieceMargin = 1.5;
// Nanoseconds to sort a corner of the nets into its component.
constexpr double kCorner = 300;

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

// Net by net onto the surface and its creases. `part`: the function in the box of the grid, if
// that is less than the whole.
ExactMesh onto(const Survey& survey, const ImplicitFunction* part, Nets nets,
               const GridLayout& layout, WorkBudget& budget, const RunContext& context) {
  // One smooth piece all over the box has one name, and no creases.
  const bool smooth = part && !part->has_pieces();
  const ImplicitFunction& f = smooth ? *part : *survey.function;
  std::size_t strays = 0;
  ExactMesh mesh =
      project_nets(f, std::move(nets), layout, survey.mesh.size, budget, strays, context);
  if (smooth && !mesh.positions.empty()) {
    std::ranges::fill(mesh.pieces, survey.function->piece(mesh.positions.front()));
  }
  cut_along_creases(mesh, f, context);
  budget = mesh.budget;
  return mesh;
}

double nearest(const ExactMesh& mesh, Vec3 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& q : mesh.positions) least = std::min(least, glm::distance(p, q));
  return least;
}

// The component in a box that comes nearest to a point of it.
std::optional<ExactMesh> nearest_in(const Survey& survey, const Box3& box, Vec3 point, double step,
                                    WorkBudget& budget, const RunContext& context) {
  std::optional<ExactMesh> best;
  double least = 2 * step;
  for (ExactMesh& m : components_in(survey, box, step, budget, context)) {
    const double d = nearest(m, point);
    if (m.triangles.empty() || d >= least) continue;
    least = d;
    best = std::move(m);
  }
  return best;
}

}  // namespace

std::vector<ExactMesh> components_in(const Survey& survey, const Box3& box, double step,
                                     WorkBudget& budget, const RunContext& context) {
  const Grid grid(*survey.function, make_layout(box, step), budget, context);
  const GridLayout& layout = grid.layout();
  const auto part = survey.function->restricted(layout.box(Cell(0), layout.cells));
  std::vector<ExactMesh> meshes;
  const Nets all = make_nets(grid, context);
  budget.spend(static_cast<double>(all.corners.size()), kCorner);
  for (Nets& nets : closed_components(all)) {
    context.check();
    meshes.push_back(onto(survey, part.get(), std::move(nets), layout, budget, context));
  }
  return meshes;
}

std::optional<ExactMesh> mesh_piece(const Survey& survey, const Component& piece, double step,
                                    WorkBudget& budget, const RunContext& context) {
  // Its box may be that of a coarse mesh, which sees of a ball what is around one sample.
  constexpr int kEnlargements = 3;
  constexpr double kMostAcross = 60;  // steps
  constexpr double kOneShare = 0.2;   // of the budget
  Box3 around = grown(piece.box, kPieceMargin * step);
  double own = step, next = 0;
  for (int i = 0; i <= kEnlargements && next <= kOneShare * budget.left(); ++i) {
    const double begun = budget.left();
    if (auto best = nearest_in(survey, around, piece.point, own, budget, context)) {
      if (own <= step) return best;
      const Component found{box_of(best->positions), piece.point, own};
      const double finer = std::max(step, longest(found.box) / kMostAcross);
      auto again = nearest_in(survey, grown(found.box, own), piece.point, finer, budget, context);
      return again ? std::move(again) : std::move(best);
    }
    const double before = longest(around) / own;
    around = grown(around, std::max(0.5 * longest(around), 0.5 * piece.step));
    own = std::max(step, longest(around) / kMostAcross);
    // As much more surface as the box is larger.
    const double larger = longest(around) / own / before;
    next = larger * larger * (begun - budget.left());
  }
  return std::nullopt;
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

}  // namespace burin
