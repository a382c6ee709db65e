#include "pieces.h"

#include "boxes.h"
#include "clusters.h"
#include "piece_mesh.h"
#include "point_cells.h"
#include "specks.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace burin {
namespace {

// What the places of one look are, one cluster after the other.
class Finder {
 public:
  Finder(Survey& survey, const std::vector<HiddenPlace>& places, const GridLayout& layout,
         WorkBudget& budget, const RunContext& context)
      : survey_(survey),
        layout_(layout),
        budget_(budget),
        context_(context),
        passed_(survey.mesh, places, layout),
        known_(survey.mesh) {}

  // The places of it that are in none of the components that were found, where any was.
  std::vector<HiddenPlace> add(const Cluster& cluster) {
    // Part of a wall as thin as a cell, which the look has in part.
    constexpr std::size_t kMany = 64;
    constexpr double kThin = 0.3;
    const double passed = passed_.share(cluster);
    if (cluster.cells.size() > kMany && passed > kThin) return {};
    constexpr double kOfSide = 0.7, kOfCell = 0.25;
    const double step = std::min(kOfSide * cluster.side, kOfCell * layout_.step);
    Box3 around = grown(cluster.box, layout_.step);
    // A piece that leaves the box is longer than what was seen of it.
    constexpr int kEnlargements = 4;
    constexpr double kMostSteps = 4000;
    constexpr double kOneShare = 0.2;  // of the budget, to follow one piece out of its box
    if (longest(around) > kMostSteps * step || expected(cluster, around, step) > budget_.left()) {
      throw TooMuchWork();
    }
    double next = 0;
    for (int i = 0; i <= kEnlargements && longest(around) < kMostSteps * step; ++i) {
      if (next > kOneShare * budget_.left()) throw TooMuchWork();
      const double begun = budget_.left();
      std::vector<Box3> taken;
      for (const ExactMesh& m : components_in(survey_, around, step, budget_, context_)) {
        if (take(m, step)) taken.push_back(survey_.pieces.back().box);
      }
      if (!taken.empty()) return left_of(cluster, taken);
      if (i > 0 && passed > 0) break;
      around = grown(around, 0.5 * longest(around));
      // Twice as long, with four times the surface.
      next = 4 * (begun - budget_.left());
    }
    return {};
  }

 private:
  // Nanoseconds to look at a vertex of the mesh, and to name its component anew.
  static constexpr double kVertex = 5, kComponents = 100;
  // A component of the look with less of the diagonal is a fragment.
  static constexpr double kFragment = 0.6;

  // Nanoseconds that meshing takes, as if the surface passed once through each cell of the cluster
  // and of the look's mesh around it: nothing is begun that does not come to an end.
  double expected(const Cluster& cluster, const Box3& around, double step) {
    constexpr double kVertexValues = 20;  // some samples, and the way onto the surface
    constexpr double kSmall = 8;          // cells along a box that holds little else
    auto cells = static_cast<double>(cluster.cells.size());
    if (longest(around) > kSmall * layout_.step) {
      const std::vector<Vec3>& vertices = survey_.mesh.positions;
      budget_.spend(static_cast<double>(vertices.size()), kVertex);
      cells += static_cast<double>(
          std::ranges::count_if(vertices, [&](Vec3 p) { return around.contains(p); }));
    }
    const double along = layout_.step / step;
    return cells * along * along * kVertexValues * survey_.function->cost();
  }

  static std::vector<HiddenPlace> left_of(const Cluster& cluster, const std::vector<Box3>& taken) {
    std::vector<HiddenPlace> left;
    for (const HiddenPlace& p : cluster.places) {
      if (std::ranges::none_of(taken, [&](const Box3& b) { return b.overlaps(p.box); })) {
        left.push_back(p);
      }
    }
    return left;
  }

  bool is_taken(const Component& piece) const {
    return std::ranges::any_of(survey_.pieces, [&](const Component& p) {
      return p.box.contains(piece.box.center()) && piece.box.contains(p.box.center()) &&
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
    budget_.spend(static_cast<double>(known_.boxes.size()), kVertex);
    bool any = false;
    for (std::uint32_t v = 0; v < known_.boxes.size(); ++v) {
      const Vec3 p = survey_.mesh.positions[v];
      if (!around.contains(p) || !near.any_near(p)) continue;
      const std::uint32_t set = known_.sets.find(v);
      if (known_.boxes[set].diagonal() > kFragment * piece.box.diagonal()) return false;
      fragment[set] = 1;
      any = true;
    }
    if (any) {
      budget_.spend(static_cast<double>(known_.boxes.size()), kComponents);
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
  const PassedCells passed_;
  MeshComponents known_;  // both of what was there when it was made
};

// What meshing a cluster takes, to compare it with others.
double size_of(const Cluster& c) { return longest(c.box) / c.side; }

}  // namespace

bool add_hidden_pieces(Survey& survey, const std::vector<HiddenPlace>& places,
                       const GridLayout& layout, WorkBudget& budget, const RunContext& context) {
  if (places.empty()) return true;
  // What may be meshed in vain: of walls as thin as a cell each sample is a cluster.
  constexpr double kMostVain = 0.1;
  double vain = kMostVain * budget.left();
  std::vector<HiddenPlace> not_meshed;
  // Each time fewer, so that it ends.
  std::vector<Cluster> clusters = clusters_of(places);
  std::ranges::stable_sort(clusters, {}, size_of);
  Finder finder(survey, places, layout, budget, context);
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    context.check();
    try {
      budget.spend(0, 0);  // ends what the last one has used up
      if (vain < 0) throw TooMuchWork();
      const std::size_t before = survey.pieces.size();
      const double begun = budget.left();
      const auto left = finder.add(clusters[i]);
      if (survey.pieces.size() == before) vain -= begun - budget.left();
      if (left.empty()) continue;
      for (Cluster& c : clusters_of(left)) clusters.push_back(std::move(c));
    } catch (const TooMuchWork&) {
      const auto& left = clusters[i].places;
      not_meshed.insert(not_meshed.end(), left.begin(), left.end());
    }
  }
  if (not_meshed.empty()) return true;
  // Parts of what is there already may be among them.
  const PassedCells passed(survey.mesh, not_meshed, layout);
  return std::ranges::all_of(clusters_of(not_meshed),
                             [&](const Cluster& c) { return passed.longest_missing(c) == 0; });
}

double longest_missing(const Survey& survey, const HiddenPlaces& hidden, const GridLayout& layout) {
  // Of the cells of those of which nothing could be told, by a surface that explains them.
  constexpr double kExplained = 0.5;
  double most = 0;
  if (!hidden.places.empty()) {
    const PassedCells passed(survey.mesh, hidden.places, layout);
    for (const Cluster& c : clusters_of(hidden.places)) {
      most = std::max(most, passed.longest_missing(c));
    }
  }
  if (!hidden.doubtful.empty()) {
    const PassedCells passed(survey.mesh, hidden.doubtful, layout);
    for (const Cluster& c : clusters_of(hidden.doubtful)) {
      if (passed.share(c) < kExplained) most = std::max(most, longest(c.box));
    }
  }
  return most;
}

}  // namespace burin
