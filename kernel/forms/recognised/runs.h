#pragma once
// Facets that touch one cone or cylinder at equal steps of a turn; internal to the module.

#include <burin/base/run_context.h>
#include <burin/mesh/tri_mesh.h>

#include "facets.h"
#include "revolution.h"

#include <cmath>
#include <cstdint>
#include <vector>

namespace burin::recognised {

/// A cone or cylinder by the planes that touch it: (n_i - rise direction) of equal length.
struct Fit {
  Axis axis;
  double rise = 0, offset = 0;  // n . direction; n . (x - origin) of all facets
  double step = 0;
  double side = 1;  // 1: facets look away from the axis
  Vec3 phase{1, 0, 0};

  double spread() const { return std::sqrt(1 - rise * rise); }
  /// Radius of the circle through the vertices at a height.
  double radius(double h) const {
    return side * (offset - rise * h) / spread() / std::cos(0.5 * step);
  }
  double sagitta(double h) const { return std::abs(radius(h)) * (1 - std::cos(0.5 * step)); }
  /// The angle of a point around the axis, from the phase.
  double angle(Vec3 p) const {
    const Vec3 d = p - axis.origin;
    return std::atan2(glm::dot(glm::cross(phase, d), axis.direction), glm::dot(phase, d));
  }
  Vec3 spoke(double angle) const {
    return std::cos(angle) * phase + std::sin(angle) * glm::cross(axis.direction, phase);
  }
};

struct Run {
  Fit fit;
  std::vector<std::int32_t> facets;
};

/// Of fewer facets nothing is known.
constexpr std::size_t kLeastFacets = 3;

/// Finds runs among facets. Mesh and facets outlive it.
class RunFinder {
 public:
  RunFinder(const TriMesh& mesh, const Facets& facets)
      : mesh_(mesh), facets_(facets), runs_of_(facets.list.size()) {}

  /// Once. A facet may be in several. Throws Cancelled. Cost: for each facet a test of each pair
  /// among its 8 neighbours with the longest edges, and of the facets of each run.
  std::vector<Run> find(const RunContext& context);

  /// Whether a facet lies in one of the planes of the run, within its share of the turn.
  bool holds(const Fit& fit, const Facet& f) const;

  /// Three planes at equal angles always touch some circle: of so few each facet must fill its
  /// share of the turn, too.
  bool enough(const Run& run) const;

 private:
  const Facet& facet(std::int32_t f) const { return facets_.list[static_cast<std::size_t>(f)]; }
  void begin_at(std::int32_t middle);
  bool known(std::int32_t a, std::int32_t b, std::int32_t c) const;
  void try_run(std::int32_t a, std::int32_t b, std::int32_t c);
  void grow(Run& run, std::int32_t seed) const;
  void refine(Run& run) const;
  std::size_t steps(const Run& run) const;
  bool goes_on_alike(const Run& run) const;
  double width(const Facet& f, Vec3 axis) const;
  bool meet_along(const Facet& a, const Facet& b, Vec3 axis) const;

  const TriMesh& mesh_;
  const Facets& facets_;
  std::vector<Run> runs_;
  std::vector<std::vector<std::int32_t>> runs_of_;
};

}  // namespace burin::recognised
