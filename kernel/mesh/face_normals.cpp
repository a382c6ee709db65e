#include <burin/base/parallel.h>
#include <burin/base/parallel_filter.h>

#include "build_steps.h"

namespace burin {

namespace {

/// A triangle whose height over its longest edge is under this share of that edge gets no normal of
/// its own: single precision files round corners by 6e-8 of their coordinates, which turns such a
/// triangle by degrees.
constexpr double kSliverHeight = 1e-5;

struct LongestEdge {
  int corner;
  double squared;
};

LongestEdge longest_edge(const TriMesh& mesh, std::size_t f) {
  LongestEdge best{0, -1};
  for (int k = 0; k < 3; ++k) {
    const Triangle& t = mesh.triangles[f];
    const Vec3 e = mesh.positions[t[static_cast<std::size_t>((k + 1) % 3)]] -
                   mesh.positions[t[static_cast<std::size_t>(k)]];
    if (glm::dot(e, e) > best.squared) best = {k, glm::dot(e, e)};
  }
  return best;
}

}  // namespace

std::vector<Vec3> face_normals(const TriMesh& mesh, const RunContext& context) {
  std::vector<Vec3> normals(mesh.triangles.size());
  parallel_for(
      normals.size(), kFaceGrain,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
          normals[f] = mesh.normal(static_cast<std::uint32_t>(f));
        }
      },
      &context);
  return normals;
}

void mend_sliver_normals(const TriMesh& mesh, const Topology& topology, std::vector<Vec3>& normals,
                         const RunContext& context) {
  const auto is_sliver = [&](std::uint32_t f) {
    return 2 * mesh.area(f) <= kSliverHeight * longest_edge(mesh, f).squared;
  };
  std::vector<std::uint32_t> slivers =
      parallel_filter<std::uint32_t>(normals.size(), kFaceGrain, is_sliver, context);
  std::vector<std::uint8_t> unknown(slivers.empty() ? 0 : normals.size(), 0);
  for (const std::uint32_t f : slivers) unknown[f] = 1;
  // Slivers often lie side by side: each pass hands normals one further. What stays unknown keeps
  // its own.
  for (int pass = 0; pass < 8 && !slivers.empty(); ++pass) {
    std::vector<std::uint32_t> left;
    for (const std::uint32_t f : slivers) {
      const HalfEdge h = static_cast<HalfEdge>(3 * f) + longest_edge(mesh, f).corner;
      const HalfEdge o = topology.opposite[static_cast<std::size_t>(h)];
      if (o == kNoHalfEdge || unknown[face_of(o)]) {
        left.push_back(f);
      } else {
        normals[f] = normals[face_of(o)];
        unknown[f] = 0;
      }
    }
    if (left.size() == slivers.size()) break;
    slivers = std::move(left);
  }
}

}  // namespace burin
