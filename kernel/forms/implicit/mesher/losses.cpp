#include "losses.h"

#include "boxes.h"
#include "piece_mesh.h"
#include "point_cells.h"
#include "specks.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

// Steps of the whole mesh: larger components are not lost whole.
constexpr double kLarge = 6;

struct Lost {
  Component piece;
  std::vector<std::uint32_t> fragments;  // components of the mesh, by the names of their sets
};

// The components of a first look beside those of a mesh made afterwards.
class Losses {
 public:
  Losses(ExactMesh& mesh, const Survey& survey, WorkBudget& budget, const RunContext& context)
      : mesh_(mesh),
        survey_(survey),
        budget_(budget),
        context_(context),
        expected_(survey.mesh),
        made_(mesh),
        own_(vertices_of(expected_)),
        one_sided_(one_sided_components(mesh, made_, kLarge * mesh.step)),
        dropped_(made_.boxes.size(), 0),
        match_(expected_.boxes.size(), kNone),
        near_(mesh.positions, kReach * mesh.step),
        beside_(mesh.positions, kNear * survey.mesh.step) {
    for (std::uint32_t m = 0; m < made_.boxes.size(); ++m) {
      if (!made_.boxes[m].empty()) components_.push_back(m);
    }
  }

  // What is not there, but in fragments.
  std::vector<Lost> find() {
    std::vector<std::uint8_t> lost(expected_.boxes.size(), 0);
    std::vector<Lost> out;
    // Fewer are left each time.
    for (bool more = true; more;) {
      more = false;
      for (std::uint32_t e = 0; e < lost.size(); ++e) {
        if (lost[e] || expected_.boxes[e].empty() || is_matched(e)) continue;
        context_.check();
        budget_.spend(static_cast<double>(components_.size() + own_[e].size()), kEach);
        if (is_there(e)) continue;
        lost[e] = 1;
        more = true;
        Lost& l = out.emplace_back();
        l.piece = {expected_.boxes[e], survey_.mesh.positions[e], survey_.mesh.step_at(e)};
        for (const std::uint32_t m : components_) {
          if (!is_part(m, e)) continue;
          dropped_[m] = 1;
          l.fragments.push_back(m);
        }
      }
    }
    return out;
  }

  // Leaves out the fragments of those that were meshed.
  void drop(const std::vector<std::uint32_t>& fragments) {
    if (fragments.empty()) return;
    std::ranges::fill(dropped_, std::uint8_t{0});
    for (const std::uint32_t m : fragments) dropped_[m] = 1;
    drop_components(mesh_, made_, dropped_);
  }

 private:
  static constexpr double kSmallest = 0.3, kLargest = 1.5;  // shares of a component's diagonal
  static constexpr double kReach = 1.5;                     // steps
  static constexpr double kEach = 20;                       // nanoseconds
  static constexpr std::uint32_t kNone = 0xffffffff, kSure = 0xfffffffe;

  static std::vector<std::vector<std::uint32_t>> vertices_of(MeshComponents& parts) {
    std::vector<std::vector<std::uint32_t>> out(parts.boxes.size());
    for (std::uint32_t v = 0; v < out.size(); ++v) {
      const std::uint32_t set = parts.sets.find(v);
      if (!parts.boxes[set].empty()) out[set].push_back(v);
    }
    return out;
  }

  bool is_large(const Box3& b) const { return b.diagonal() >= kLarge * mesh_.step; }

  // Whether it was found to be there by what is there still.
  bool is_matched(std::uint32_t e) const {
    return match_[e] == kSure || (match_[e] != kNone && !dropped_[match_[e]]);
  }

  bool is_there(std::uint32_t e) {
    const Box3& box = expected_.boxes[e];
    if (is_large(box)) {
      const Vec3 p = survey_.mesh.positions[e];
      const bool there = near_.any_near(p);
      if (there) match_[e] = kSure;
      return there;
    }
    for (const std::uint32_t m : components_) {
      if (dropped_[m] || one_sided_[m]) continue;
      const double size = made_.boxes[m].diagonal();
      if (size < kSmallest * box.diagonal() || size > kLargest * box.diagonal()) continue;
      if (!box.contains(made_.boxes[m].center())) continue;
      match_[e] = m;
      return true;
    }
    if (!is_joined(e)) return false;
    match_[e] = kSure;
    return true;
  }

  // Of a fragment, as grids leave of thin wires.
  bool is_part(std::uint32_t m, std::uint32_t e) const {
    const Box3 &part = made_.boxes[m], &box = expected_.boxes[e];
    return !is_large(box) && part.diagonal() <= kLargest * box.diagonal() && part.overlaps(box);
  }

  // Whether it has become part of a larger one, which lies within a step of it.
  bool is_joined(std::uint32_t e) {
    const double near = kNear * survey_.mesh.step_at(e), size = expected_.boxes[e].diagonal();
    return std::ranges::any_of(own_[e], [&](std::uint32_t u) {
      const Vec3 p = survey_.mesh.positions[u];
      return beside_.any_near(p, [&](std::uint32_t v) {
        const std::uint32_t m = made_.sets.find(v);
        return glm::distance(mesh_.positions[v], p) < near && !one_sided_[m] &&
               made_.boxes[m].diagonal() > kLargest * size;
      });
    });
  }

  ExactMesh& mesh_;
  const Survey& survey_;
  WorkBudget& budget_;
  const RunContext& context_;
  MeshComponents expected_, made_;
  std::vector<std::vector<std::uint32_t>> own_;  // vertices of what is expected
  std::vector<std::uint8_t> one_sided_;          // components of the mesh
  std::vector<std::uint32_t> components_;        // of the mesh
  std::vector<std::uint8_t> dropped_;
  // For each that is expected: the component of the mesh that it is, or one of those above.
  std::vector<std::uint32_t> match_;
  PointCells near_, beside_;
};

// Steps that hold the tolerance, across a piece of some.
double step_for(const Component& piece, double tolerance) {
  constexpr double kMostAcross = 60;     // steps
  constexpr double kEdgePerStep = 1.25;  // as in choose_step
  const double size = longest(piece.box);
  const double wanted = std::sqrt(4 * size * tolerance) / kEdgePerStep;
  return std::min(piece.step, std::clamp(wanted, size / kMostAcross, size / kStepsAcross));
}

}  // namespace

bool add_lost_pieces(ExactMesh& mesh, const Survey& survey, double tolerance, WorkBudget budget,
                     const RunContext& context) {
  // What may be meshed in vain: of a wall as thin as a cell each sample is such a piece.
  constexpr double kMostVain = 0.1;
  double vain = kMostVain * budget.left();
  Losses losses(mesh, survey, budget, context);
  std::vector<ExactMesh> parts;
  std::vector<std::uint32_t> fragments;
  bool all = true;
  try {
    for (const Lost& lost : losses.find()) {
      context.check();
      if (vain < 0) break;
      const double begun = budget.left();
      auto part = mesh_piece(survey, lost.piece, step_for(lost.piece, tolerance), budget, context);
      if (part) {
        parts.push_back(std::move(*part));
        fragments.insert(fragments.end(), lost.fragments.begin(), lost.fragments.end());
      } else {
        vain -= begun - budget.left();
        all = false;
      }
    }
  } catch (const TooMuchWork&) {
    all = false;
  }
  losses.drop(fragments);
  for (const ExactMesh& part : parts) append(mesh, part);
  return all;
}

}  // namespace burin
