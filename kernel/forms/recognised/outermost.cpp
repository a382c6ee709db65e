#include "outermost.h"

#include "refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <tuple>
#include <vector>

namespace burin::recognised {
namespace {

// Sagittas that a surface may lie beyond the corners of a facet: two and some more where it meets
// others.
constexpr double kOutermostReach = 8;
// Passes, and how much finer each is than the one before: only what is farthest is divided again.
constexpr int kOutermostPasses = 2;
constexpr double kFinerPass = 64;

// Triangles that are divided again on each side of the box.
constexpr std::size_t kMostFarthest = 4;

/// Triangles with the patches and facets that they are of.
struct Triangles {
  const TriMesh& mesh;
  const std::vector<std::int32_t>&patch, &facet;
};

/// The marked triangles, with all around them: corners are placed on all surfaces that meet there.
/// The faces of the result are 1 and 0.
FacetMesh with_neighbours(const Triangles& from, const std::vector<std::uint8_t>& marked) {
  const std::size_t n = from.mesh.triangles.size();
  std::vector<std::uint8_t> at_corner(from.mesh.positions.size(), 0);
  for (std::size_t t = 0; t < n; ++t) {
    if (marked[t] == 0) continue;
    for (const std::uint32_t v : from.mesh.triangles[t]) at_corner[v] = 1;
  }
  FacetMesh out;
  std::vector<std::int32_t> number(from.mesh.positions.size(), -1);
  for (std::size_t t = 0; t < n; ++t) {
    Triangle tri = from.mesh.triangles[t];
    if (std::ranges::none_of(tri, [&](std::uint32_t v) { return at_corner[v] != 0; })) continue;
    for (std::uint32_t& v : tri) {
      if (number[v] < 0) {
        number[v] = static_cast<std::int32_t>(out.mesh.positions.size());
        out.mesh.positions.push_back(from.mesh.positions[v]);
      }
      v = static_cast<std::uint32_t>(number[v]);
    }
    out.mesh.triangles.push_back(tri);
    out.patch.push_back(from.patch[t]);
    out.facet.push_back(from.facet[t]);
    out.face.push_back(marked[t]);
  }
  out.edge.assign(3 * out.mesh.triangles.size(), -1);
  out.normal.assign(3 * out.mesh.triangles.size(), Vec3(0));
  return out;
}

std::array<Vec3, 6> rows_both_ways(const Mat3& axes) {
  const Mat3 rows = glm::transpose(axes);
  return {rows[0], -rows[0], rows[1], -rows[1], rows[2], -rows[2]};
}

/// Round facets whose surface may stick out of the box.
std::vector<std::uint8_t> may_stick_out(const Triangles& from, const Recognised& round,
                                        const Box3& box, const Mat3& axes) {
  const Mat3 rows = glm::transpose(axes);
  const Vec3 stretch(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
  std::vector<std::uint8_t> out(from.patch.size(), 0);
  for (std::size_t t = 0; t < out.size(); ++t) {
    if (from.patch[t] < 0) continue;
    const double sagitta = round.patches[static_cast<std::size_t>(from.patch[t])].sagitta;
    const Vec3 reach = kOutermostReach * sagitta * stretch;
    out[t] = std::ranges::any_of(from.mesh.triangles[t], [&](std::uint32_t v) {
      const Vec3 p = axes * from.mesh.positions[v];
      for (int k = 0; k < 3; ++k) {
        if (p[k] - reach[k] < box.min[k] || p[k] + reach[k] > box.max[k]) return true;
      }
      return false;
    });
  }
  return out;
}

/// Of the triangles that may stick out those whose middles are farthest on each side; of those that
/// are equal within `step` mm the largest: these may bulge most.
std::vector<std::uint8_t> farthest(const FacetMesh& from, const Mat3& axes, double step) {
  struct Candidate {
    double height = 0, area = 0;
    std::size_t triangle = 0;
  };
  std::vector<Candidate> round;
  for (std::size_t t = 0; t < from.face.size(); ++t) {
    if (from.face[t] == 0 || from.patch[t] < 0) continue;
    round.push_back({0, from.mesh.area(static_cast<std::uint32_t>(t)), t});
  }
  std::vector<std::uint8_t> out(from.face.size(), 0);
  for (const Vec3& row : rows_both_ways(axes)) {
    for (Candidate& c : round) {
      Vec3 middle(0);
      for (const std::uint32_t v : from.mesh.triangles[c.triangle]) {
        middle += from.mesh.positions[v] / 3.0;
      }
      c.height = std::floor(glm::dot(row, middle) / (step * glm::length(row)));
    }
    const auto end =
        round.begin() + static_cast<std::ptrdiff_t>(std::min(kMostFarthest, round.size()));
    std::ranges::partial_sort(round, end, std::greater(), [](const Candidate& c) {
      return std::tuple(c.height, c.area, c.triangle);
    });
    for (auto c = round.begin(); c != end; ++c) out[c->triangle] = 1;
  }
  return out;
}

}  // namespace

void add_outermost(Box3& box, const Mat3& axes, const TriMesh& mesh, const Recognised& round,
                   const Facets& facets, double tolerance, const RunContext& context) {
  std::vector<std::int32_t> patch;
  patch.reserve(facets.of.size());
  for (const std::int32_t facet : facets.of) {
    patch.push_back(round.patch_of[static_cast<std::size_t>(facet)]);
  }
  const Triangles read{mesh, patch, facets.of};
  FacetMesh finer = with_neighbours(read, may_stick_out(read, round, box, axes));
  for (int pass = 0; pass < kOutermostPasses && !finer.mesh.triangles.empty(); ++pass) {
    const std::size_t corners = finer.mesh.positions.size();
    refine(finer, round, facets, tolerance, context);
    for (std::size_t t = 0; t < finer.mesh.triangles.size(); ++t) {
      if (finer.face[t] == 0) continue;
      for (const std::uint32_t v : finer.mesh.triangles[t]) {
        if (v >= corners) box.add(axes * finer.mesh.positions[v]);
      }
    }
    finer =
        with_neighbours({finer.mesh, finer.patch, finer.facet}, farthest(finer, axes, tolerance));
    tolerance /= kFinerPass;
  }
}

}  // namespace burin::recognised
